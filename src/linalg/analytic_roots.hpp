#pragma once

#include <complex>
#include <functional>
#include <optional>

namespace bempd::linalg {

using AnalyticFunction = std::function<std::complex<double>(const std::complex<double>&)>;

struct RealRange {
  double from, to;
};

// Root with the least real part in a range, and an imaginary part up to a bound; empty if there is none. At conjugate
// places the function must have conjugate values up to a factor; of two conjugate roots, the upper one is returned. No
// root is missed, because it is found by the argument principle. The function must not vanish on the ends of the range.
std::optional<std::complex<double>> leftmost_root(const AnalyticFunction& function, RealRange range,
                                                  double most_imaginary);

}  // namespace bempd::linalg

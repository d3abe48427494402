#pragma once

#include <complex>
#include <functional>
#include <optional>

namespace bempd::linalg {

using AnalyticFunction = std::function<std::complex<double>(const std::complex<double>&)>;

struct RealRange {
  double from, to;
};

// Root with the least real part in a range and an imaginary part between -most_imaginary and most_imaginary; empty if
// there is none. At conjugate places the function must have conjugate values up to a constant factor; of two conjugate
// roots, the upper one is returned. The argument principle is used, so that no root is missed. The function must not
// vanish at the ends of the range.
std::optional<std::complex<double>> leftmost_root(const AnalyticFunction& function, RealRange range,
                                                  double most_imaginary);

}  // namespace bempd::linalg

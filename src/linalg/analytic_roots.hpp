#pragma once

#include <complex>
#include <functional>
#include <optional>

namespace bempd::linalg {

using AnalyticFunction = std::function<std::complex<double>(const std::complex<double>&)>;

struct RealRange {
  double from, to;
};

// Root with the least real part in a range, and an imaginary part within a bound, of a function that has conjugate
// values at conjugate places up to a factor; of a conjugate pair, the one with the positive imaginary part. It is found
// by the argument principle, so that no root is missed; the function must not vanish on the ends of the range.
std::optional<std::complex<double>> leftmost_root(const AnalyticFunction& function, RealRange range,
                                                  double most_imaginary);

}  // namespace bempd::linalg

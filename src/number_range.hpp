#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd {

// Energy limited to the range of doubles: infinity and NaN become the largest double, -infinity the lowest double.
// Model warns of such an energy.
inline double in_range(double value) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::isnan(value) ? largest : std::clamp(value, -largest, largest);
}

// Exponent of the power of 2 by which numbers of magnitude `size` must be divided before they are squared, so that the
// squares neither overflow nor underflow; 0 for ordinary sizes. Division by a power of 2 changes no digit. The
// reciprocal of the power is finite even for the smallest numbers.
inline int far_exponent(double size) {
  constexpr int far = 200, least = -1000;
  if (!(size > 0) || !std::isfinite(size)) return 0;
  const int exponent = std::ilogb(size);
  return std::abs(exponent) > far ? std::max(exponent, least) : 0;
}

}  // namespace bempd

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd {

// Energy as a number: one beyond the range of doubles becomes the largest double, and Model warns of it.
inline double in_range(double value) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::isnan(value) ? largest : std::clamp(value, -largest, largest);
}

// Exponent of 2 by which numbers of this size, and their squares, are to be divided before they are squared: 0 except
// for sizes whose squares no double holds. The division changes no digit.
inline int far_exponent(double size) {
  constexpr int far = 200;
  if (!(size > 0) || !std::isfinite(size)) return 0;
  const int exponent = std::ilogb(size);
  return std::abs(exponent) > far ? exponent : 0;
}

}  // namespace bempd

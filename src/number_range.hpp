#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd {

// Energies that no number can hold are told as the largest one, and Model warns of them.
inline double in_range(double value) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::isnan(value) ? largest : std::clamp(value, -largest, largest);
}

// Exponent of 2 by which numbers of this size are to be divided before they are squared, and their squares: 0 but for
// sizes whose squares no number holds. Dividing alters no digit.
inline int far_exponent(double size) {
  constexpr int far = 200;
  if (!(size > 0) || !std::isfinite(size)) return 0;
  const int exponent = std::ilogb(size);
  return std::abs(exponent) > far ? exponent : 0;
}

}  // namespace bempd

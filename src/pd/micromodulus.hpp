#pragma once

#include <algorithm>
#include <numbers>

namespace bempd::pd {

// Bonds as discretized by Yang and Liu (Int. J. Solids Struct., 2021), with the micromodulus of Huang et al. (2015),
// for C1111 = 1 and lengths in units of the lattice spacing.

// Micromodulus of Eq. 13 for a bond of the length r and the horizon delta, c0 (1 - r^2/delta^2)^2. With Young's modulus
// E, the constants c0 = 315 E / (8 pi delta^3) of plane stress and 42 E / (pi delta^3) of plane strain are both equal
// to 35 C1111 / (pi delta^3).
inline double micromodulus(double length, double horizon) {
  const double s = length / horizon;
  return 35 / std::numbers::pi / (horizon * horizon * horizon) * (1 - s * s) * (1 - s * s);
}

// Volume factor of Eq. 19: the fraction of a far point's cell that lies within the horizon. It falls linearly where the
// horizon cuts the cell.
inline double volume_factor(double length, double horizon) { return std::min(1.0, horizon + 0.5 - length); }

}  // namespace bempd::pd

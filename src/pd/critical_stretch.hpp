#pragma once

#include <cmath>
#include <numbers>

#include "elasticity/plane_elasticity.hpp"

namespace bempd::pd {

// Stretch at which all bonds across a line of unit length dissipate the fracture energy G0, for the micromodulus
// c0 (1 - r^2/delta^2)^2. Silling and Askari (Comput. Struct. 83, 2005) integrate the work of separation; with this
// micromodulus int_0^1 (1 - s^2)^2 s^3 ds = 1/24, so that G0 = s_c^2 c0 delta^4 / 24.
inline double critical_stretch(double fracture_energy, double young_modulus, double horizon, PlaneState state) {
  const double coefficient = state == PlaneState::stress ? 64.0 / 105.0 : 4.0 / 7.0;
  return std::sqrt(coefficient * std::numbers::pi * fracture_energy / (young_modulus * horizon));
}

}  // namespace bempd::pd

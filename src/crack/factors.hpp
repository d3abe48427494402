#pragma once

#include "geometry/point.hpp"

namespace bempd::crack {

// Stress intensity factors K_I and K_II of a tip as affine functions of the load factor [Pa m^(1/2)].
struct AffineFactors {
  Point constant{0, 0}, proportional{0, 0};

  Point at(double load_factor) const { return constant + load_factor * proportional; }
};

}  // namespace bempd::crack

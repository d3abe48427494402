#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// E' of plane stress or strain.
double plane_modulus(const PlaneElasticity& elasticity);

// The smallest load factor >= 0 at which |constant + factor * proportional|, the factors K_I and K_II, is the
// toughness; infinite if it never is.
double critical_load_factor(const Point& constant, const Point& proportional, double toughness);

}  // namespace bempd

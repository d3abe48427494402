#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// E' of plane stress or strain.
double plane_modulus(const PlaneElasticity& elasticity);

// The smallest load factor >= 0 at which the energy release rate of growth straight on is the fracture energy:
// |constant + factor * proportional|, the factors K_I and K_II, is the toughness there; the largest double if it never
// is. A tip under shear turns and grows earlier (crack::growth_range()).
double straight_load_factor(const Point& constant, const Point& proportional, double toughness);

}  // namespace bempd

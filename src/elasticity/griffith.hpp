#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Modulus E' of plane stress or plane strain.
double plane_modulus(const PlaneElasticity& elasticity);

// Smallest load factor >= 0 at which the energy release rate of growth straight on reaches the fracture energy: there
// |constant + factor * proportional|, where both are pairs K_I and K_II, is the toughness. It is the largest double if
// there is none. A tip under shear turns and grows earlier (crack::growth_range()).
double straight_load_factor(const Point& constant, const Point& proportional, double toughness);

}  // namespace bempd

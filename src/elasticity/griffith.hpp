#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Plane modulus E' [Pa]: E in plane stress, E / (1 - nu^2) in plane strain.
double plane_modulus(const PlaneElasticity& elasticity);

// Smallest load factor >= 0 at which the energy release rate of a tip that grows straight on reaches the fracture
// energy: there the vector (K_I, K_II) = constant + factor * proportional is as long as the toughness. The largest
// double if there is no such load factor. A tip under shear turns instead, and grows at a smaller load factor
// (crack::GrowthLaw::range()).
double straight_load_factor(const Point& constant, const Point& proportional, double toughness);

}  // namespace bempd

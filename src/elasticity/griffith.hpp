#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// E' of plane stress or strain.
double plane_modulus(const PlaneElasticity& elasticity);

// Angle in which a tip goes on by the largest hoop stress, counter-clockwise, and the mode I factor that is worth the
// two (Erdogan and Sih, J. Basic Eng. 85, 1963).
struct Kink {
  double angle, equivalent_factor;
};
Kink kink_of(const Point& factors);

// The smallest load factor >= 0 at which |constant + factor * proportional|, the factors K_I and K_II, is the
// toughness; infinite if it never is.
double critical_load_factor(const Point& constant, const Point& proportional, double toughness);

// The smallest load factor >= 0 at which the mode I factor that is worth constant + factor * proportional reaches the
// toughness.
double growth_load_factor(const Point& constant, const Point& proportional, double toughness);

}  // namespace bempd

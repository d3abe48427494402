#pragma once

#include "geometry/point.hpp"

namespace bempd {

// What decides in which direction a tip goes on.
enum class KinkCriterion { hoop_stress, energy_release_rate };

// Angle by which a tip turns as it goes on, counter-clockwise, and the mode I factor that is worth the two there.
struct Kink {
  double angle, equivalent_factor;
};

// By the largest hoop stress before the crack turns (Erdogan and Sih, J. Basic Eng. 85, 1963), or by the largest energy
// release rate after it has. An equivalent factor <= 0: nothing opens.
Kink kink_of(const Point& factors, KinkCriterion criterion = KinkCriterion::hoop_stress);

// Hoop stress around the tip in a direction, times sqrt(2 pi r): linear in the factors.
double hoop_factor(const Point& factors, double angle);

// K_I and K_II of an infinitesimal kink of this angle, |angle| < 2.5, at a tip with these factors (Amestoy and Leblond,
// Int. J. Solids Struct. 29, 1992, section 4): they depend on nothing else of the body, so that no angle needs a
// solution of its own.
Point kinked_factors(const Point& factors, double angle);

// The smallest load factor >= 0 at which the factor that is worth constant + factor * proportional reaches the
// toughness; infinite if none does.
double growth_load_factor(const Point& constant, const Point& proportional, double toughness, KinkCriterion criterion);

}  // namespace bempd

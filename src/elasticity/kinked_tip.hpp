#pragma once

#include "geometry/point.hpp"

namespace bempd {

// Criterion for the direction in which a tip grows.
enum class KinkCriterion { hoop_stress, energy_release_rate };

// Angle by which a tip turns as it grows, counter-clockwise, and the equivalent mode I factor of that kink.
struct Kink {
  double angle, equivalent_factor;
};

// Kink in the direction of the largest hoop stress before the crack turns (Erdogan and Sih, J. Basic Eng. 85, 1963), or
// of the largest energy release rate after it has turned. An equivalent factor <= 0 means that no kink opens.
Kink kink_of(const Point& factors, KinkCriterion criterion = KinkCriterion::hoop_stress);

// Hoop stress around the tip in a direction, times sqrt(2 pi r): linear in the factors.
double hoop_factor(const Point& factors, double angle);

// K_I and K_II of an infinitesimal kink of this angle, |angle| < 2.5, at a tip with these factors (Amestoy and Leblond,
// Int. J. Solids Struct. 29, 1992, section 4). They depend on nothing else of the body, so that trying angles takes no
// further solution.
Point kinked_factors(const Point& factors, double angle);

// What a straight kink of this angle gains with its length: its factors are those of the infinitesimal one and these
// times the T stress and the root of the length (Amestoy and Leblond, section 5).
Point kink_growth(double angle);

// Smallest load factor >= 0 at which the equivalent factor of constant + factor * proportional reaches the toughness;
// infinite if there is none.
double growth_load_factor(const Point& constant, const Point& proportional, double toughness, KinkCriterion criterion);

}  // namespace bempd

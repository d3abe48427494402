#pragma once

#include "geometry/point.hpp"

namespace bempd {

// Criterion for the direction in which a tip grows.
enum class KinkCriterion { hoop_stress, energy_release_rate };

// Kink: the angle by which a tip turns as it grows, counter-clockwise, and the equivalent stress intensity factor (mode
// I) in the new direction.
struct Kink {
  double angle, equivalent_factor;
};

// Kink of a tip with the stress intensity factors (K_I, K_II). By the first criterion its direction is that of the
// largest hoop stress around the tip of the straight crack (Erdogan and Sih, J. Basic Eng. 85, 1963), by the other
// criterion the direction in which an infinitesimal kink has the largest energy release rate. An equivalent factor <= 0
// means that no kink opens.
Kink kink_of(const Point& factors, KinkCriterion criterion = KinkCriterion::hoop_stress);

// Hoop stress around a tip in the direction `angle`, times sqrt(2 pi r); it is linear in the stress intensity factors
// (K_I, K_II).
double hoop_factor(const Point& factors, double angle);

// Stress intensity factors (K_I, K_II) of an infinitesimal kink of this angle, |angle| < 2.5, at a tip with the given
// stress intensity factors (Amestoy and Leblond, Int. J. Solids Struct. 29, 1992, section 4). They depend on nothing
// else, so that angles can be tried without another solution.
Point kinked_factors(const Point& factors, double angle);

// Equivalent stress intensity factor (mode I) of an infinitesimal kink of this angle by a criterion: hoop_factor(), or
// the square root of the energy release rate times E'; negative if the kink closes.
double factor_of_kink(const Point& factors, double angle, KinkCriterion criterion);

// Change of the stress intensity factors (K_I, K_II) of a straight kink as it becomes longer: the result times the
// T-stress and the square root of the kink's length is added to the factors of the infinitesimal kink (Amestoy and
// Leblond, section 5).
Point kink_growth(double angle);

// Smallest load factor >= 0 at which a tip with the stress intensity factors constant + load factor * proportional has
// an equivalent mode I factor that reaches the toughness; infinite if there is none.
double growth_load_factor(const Point& constant, const Point& proportional, double toughness, KinkCriterion criterion);

}  // namespace bempd

#pragma once

#include <cmath>
#include <limits>

#include "crack/factors.hpp"
#include "elasticity/kinked_tip.hpp"

namespace bempd::crack {

// Range of load factors in which a tip does not grow; infinite where there is no bound.
struct GrowthRange {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();

  bool is_empty() const { return lowest > highest; }  // the tip grows at every load factor
  bool holds(double load_factor) const { return lowest < load_factor && load_factor < highest; }

  // Load factor at which the tip grows next if the load factor rises (`upwards`) or falls: the present one if it lies
  // outside the range, infinite if the tip does not grow in this direction.
  double next(double present, bool upwards) const {
    if (!holds(present)) return present;
    return upwards ? highest : lowest;
  }
};

// Ratio of the equivalent mode I factor in the direction of growth to the toughness: a tip grows when it reaches 1.
double growth_ratio(const AffineFactors& factors, double load_factor, double toughness, KinkCriterion criterion);

// Range of load factors in which the equivalent mode I factor of a tip is below the toughness; unbounded if the
// toughness is infinite, or is not positive (no fracture). By the hoop stress criterion the factor is a maximum of
// functions linear in the load factor, so the range is an interval. By the energy release rate, without kinks that
// close, it is the interval around the load factor 0, or around the one at which the growth ratio is least.
GrowthRange growth_range(const AffineFactors& factors, double toughness, KinkCriterion criterion);

// Growth law of a tip at its present place: the criterion for kinks, and the properties of the material around the tip.
struct GrowthLaw {
  double toughness = 0;      // K_I at which it grows straight on; 0 or infinite: it does not grow [Pa m^(1/2)]
  double plane_modulus = 0;  // E, in plane strain E / (1 - nu^2) [Pa]
  KinkCriterion criterion = KinkCriterion::hoop_stress;

  double resistance() const { return toughness * toughness / plane_modulus; }  // energy per area [J/m^2]
  Kink kink(const AffineFactors& factors, double load_factor) const {
    return kink_of(factors.at(load_factor), criterion);
  }
  double ratio(const AffineFactors& factors, double load_factor) const {
    return toughness > 0 ? growth_ratio(factors, load_factor, toughness, criterion) : 0;
  }
  GrowthRange range(const AffineFactors& factors) const { return growth_range(factors, toughness, criterion); }
};

// Toughness: K_I at which a crack grows straight on in a material of this fracture energy [J/m^2].
inline double toughness_of(double fracture_energy, double plane_modulus) {
  return std::sqrt(plane_modulus * fracture_energy);
}

}  // namespace bempd::crack

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

  // Load factor at which the tip grows next in a direction of the load factor: the present one if it is overloaded
  // there; infinite if it does not grow in this direction.
  double next(double present, bool upwards) const {
    if (!holds(present)) return present;
    return upwards ? highest : lowest;
  }
};

// Equivalent mode I factor in the direction of growth, over the toughness: a tip grows from 1 on.
double growth_ratio(const AffineFactors& factors, double load_factor, double toughness, KinkCriterion criterion);

// Range in which the equivalent factor is below the toughness. By the hoop stress that factor is a maximum of functions
// that are linear in the load factor, so the range is an interval. By the energy release rate, without kinks that
// close, it is the interval around the load factor 0, or around the one at which the tip is loaded least. A material
// does not break if its toughness is not positive or infinite.
GrowthRange growth_range(const AffineFactors& factors, double toughness, KinkCriterion criterion);

// Law by which a tip grows where it is: the criterion in force, and what the material around it takes.
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

// K_I at which a crack grows straight on in a material of this fracture energy [J/m^2].
inline double toughness_of(double fracture_energy, double plane_modulus) {
  return std::sqrt(plane_modulus * fracture_energy);
}

}  // namespace bempd::crack

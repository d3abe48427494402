#pragma once

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

}  // namespace bempd::crack

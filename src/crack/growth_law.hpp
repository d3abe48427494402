#pragma once

#include <limits>

#include "crack/factors.hpp"
#include "elasticity/kinked_tip.hpp"

namespace bempd::crack {

// The load factors between which a tip does not grow; infinite where there is no bound.
struct GrowthRange {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();

  bool is_empty() const { return lowest > highest; }  // the tip grows at every load factor
  bool holds(double load_factor) const { return lowest < load_factor && load_factor < highest; }

  // Where the tip grows next on the way of the load factor: at the present one if it is overloaded there; infinite if
  // it does not grow in this direction.
  double next(double present, bool upwards) const {
    if (!holds(present)) return present;
    return upwards ? highest : lowest;
  }
};

// The mode I factor that is worth both factors in the direction of growth, over the toughness: a tip grows from 1 on.
double growth_ratio(const AffineFactors& factors, double load_factor, double toughness, KinkCriterion criterion);

// By the hoop stress the equivalent mode I factor is a maximum of functions that are linear in the load factor, so the
// load factors below the toughness are an interval; by the energy release rate, of which kinks that close are left out,
// it is the interval around the load factor 0, or around the one at which the tip is loaded least. A toughness that is
// not positive or infinite is that of a material that does not break.
GrowthRange growth_range(const AffineFactors& factors, double toughness, KinkCriterion criterion);

}  // namespace bempd::crack

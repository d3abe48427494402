#pragma once

#include <optional>

#include "elasticity/kinked_tip.hpp"
#include "fracture/line/tip_stress.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Factors by which a tip grows. Load factors are counted on their way, where they rise.
struct LineCriterion {
  double toughness;   // [Pa m^(1/2)]
  double correction;  // by which the intensity is multiplied before the two are compared
  KinkCriterion measure = KinkCriterion::hoop_stress;
  double present = 0;
  Control control = Control::load;
};

// The load factor at which a tip grows, and the angle by which it turns, counter-clockwise. Around it the intensity
// over the toughness is constant + load factor * growing.
struct LineLoad {
  double load_factor = 0, constant = 0, growing = 0, angle = 0;
};

// Null for a tip that does not grow on the way. The tip turns to the largest hoop stress, also where the energy release
// rate says when it grows; `turning` tells the direction, `intensity` the load.
std::optional<LineLoad> load_of_growth(const AffineIntensity& intensity, const AffineIntensity& turning,
                                       const LineCriterion& criterion);

// A ratio; null where the divisor is zero or so small that load factors know no such number.
std::optional<double> load_ratio(double dividend, double divisor);

}  // namespace bempd::fracture

#pragma once

#include <limits>

#include "crack/factors.hpp"
#include "crack/growth_law.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// What a tip of a crack that grows as a line does next, by the rule that lets it.
struct TipProspect {
  crack::TipId id;
  Point place{0, 0}, direction{1, 0};
  crack::AffineFactors factors;  // by the stress ahead of it, without the correction of its load
  double toughness = 0;          // [Pa m^(1/2)]
  double modulus = 0;            // [Pa]
  crack::GrowthRange range;      // of load factors, with the correction
  double kink_angle = 0;         // by which it turns at the present load factor, counter-clockwise [rad]
  double critical_kink_angle = std::numeric_limits<double>::quiet_NaN();  // at the highest of the range, if it has one
};

}  // namespace bempd::fracture

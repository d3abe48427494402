#pragma once

#include <optional>

#include "crack/growth_law.hpp"
#include "fracture/line/williams_fit.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// Criterion by which the tip of a crack line grows. Load factors are multiplied by the sign of the load path, so that
// they always rise.
struct LineCriterion {
  crack::GrowthLaw law;
  double correction;   // factor on the intensity before it is compared with the toughness
  double present = 0;  // present load factor
  Control control = Control::load;
};

// Growth of a tip: the load factor at which it grows, and the angle by which it turns, counter-clockwise [rad]. Near
// that load factor, constant + load factor * growing is the ratio of the tip's equivalent stress intensity factor to
// the toughness.
struct LineLoad {
  double load_factor = 0, constant = 0, growing = 0, angle = 0;
};

// Load factor and angle at which a tip grows; empty if it does not grow at any load factor on the load path. The stress
// intensity factors `turn_factors` give the angle, `intensity` the load factor. The tip turns to the direction of
// maximum hoop stress, also if the energy release rate decides when it grows. In a material whose fracture energy
// depends on the direction, one criterion decides both. If a function of the host gives the fracture energy,
// `criterion` gets the toughness at that load factor.
std::optional<LineLoad> load_of_growth(const AffineIntensity& intensity, const AffineIntensity& turn_factors,
                                       LineCriterion& criterion);

// Ratio of two numbers; empty if the divisor is zero, or so small that the ratio cannot be a load factor.
std::optional<double> load_ratio(double dividend, double divisor);

}  // namespace bempd::fracture

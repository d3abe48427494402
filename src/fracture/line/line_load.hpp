#pragma once

#include <optional>

#include "crack/growth_law.hpp"
#include "fracture/line/williams_fit.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// Criterion by which the tip of a crack line (crack in a lattice) grows. Load factors are multiplied by the sign of the
// load path (1 or -1), so that they always rise.
struct LineCriterion {
  crack::GrowthLaw law;
  double correction;   // factor on the intensity before it is compared with the toughness
  double present = 0;  // present load factor
  Control control = Control::load;
};

// Growth of a tip: the load factor at which it grows, and the angle by which it turns, counter-clockwise [rad]. Near
// that load factor f, constant + f * growing is the ratio of the tip's equivalent stress intensity factor to the
// toughness.
struct LineLoad {
  double load_factor = 0, constant = 0, growing = 0, angle = 0;
};

// Load factor and angle at which a tip grows; empty if it grows at no load factor of the load path. The angle follows
// from the stress intensity factors `turn_factors`, the load factor from `intensity`. The tip turns to the direction of
// maximum hoop stress, even if the energy release rate decides when it grows. If the material's fracture energy depends
// on the direction, one criterion decides both angle and load factor. If a function of the host gives the fracture
// energy, `criterion` gets the toughness at that load factor.
std::optional<LineLoad> load_of_growth(const AffineIntensity& intensity, const AffineIntensity& turn_factors,
                                       LineCriterion& criterion);

// Quotient of two numbers; empty if the divisor is zero, or so small that the quotient cannot be a load factor.
std::optional<double> load_ratio(double dividend, double divisor);

}  // namespace bempd::fracture

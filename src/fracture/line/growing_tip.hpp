#pragma once

#include <optional>
#include <vector>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Tip of a crack line (crack that grows in a lattice by steps).
struct GrowingTip {
  Point place{0, 0}, direction{1, 0};  // place and direction after the last step
  int law = 0;                         // number of the tip law of the region in which the tip lies
  crack::TipId id;
  crack::TipState state = crack::TipState::grows;
  // Ratios for the last steps: energy that a step has released, over the energy expected from stress intensity factors.
  // The ratios correct the load factors of the next steps.
  std::vector<double> energy_ratios{};
  // Distance ahead of `place` at which a cut through evenly spread bonds would end that takes as much stiffness as this
  // crack's cut does [m]. Known for initial cracks whose cut was placed by its stiffness (pd::CutEnd), until they grow;
  // else empty.
  std::optional<double> even_ahead{};
  double grown = 0;  // length by which the tip has grown [m]

  // Place at which the stresses and the material of the tip are evaluated: the place that lies
  // `even_ahead` in front of the tip if known, else `place`.
  Point acts_at() const { return place + even_ahead.value_or(0) * direction; }
  bool has_ended() const { return crack::has_ended(state); }
};

}  // namespace bempd::fracture

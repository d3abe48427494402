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
  // Ratios of the energy that each of the last steps has released to the energy expected from stress intensity factors.
  // They correct the load factors of the next steps.
  std::vector<double> energy_ratios{};
  // Distance from `place` to the effective tip ahead of it [m], where a crack would end that cuts as much stiffness out
  // of evenly spread bonds. Known for initial cracks with a placed cut until they grow; else empty.
  std::optional<double> even_ahead{};
  double grown = 0;  // length by which the tip has grown [m]

  // Place of the effective tip.
  Point acts_at() const { return place + even_ahead.value_or(0) * direction; }
  bool has_ended() const { return crack::has_ended(state); }
};

}  // namespace bempd::fracture

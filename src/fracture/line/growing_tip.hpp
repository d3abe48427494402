#pragma once

#include <optional>
#include <vector>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Tip of a crack that grows as a line.
struct GrowingTip {
  Point place{0, 0}, direction{1, 0};  // of its last step
  int law = 0;                         // of the run's tip laws, that of the region in which it lies
  crack::TipId id;
  crack::TipState state = crack::TipState::grows;
  // Ratios of the last steps: energy released over the energy expected from stress intensity factors. They correct the
  // load factors of the next steps.
  std::vector<double> energy_ratios{};
  // Distance ahead of `place` at which the tip acts [m]: where a crack would end that cuts as much stiffness out of
  // evenly spread bonds. Known for initial cracks with a placed cut until they grow; else empty.
  std::optional<double> even_ahead{};
  double grown = 0;  // length by which it has grown [m]

  // The place at which the tip acts.
  Point acts_at() const { return place + even_ahead.value_or(0) * direction; }
  bool has_ended() const { return crack::has_ended(state); }
};

}  // namespace bempd::fracture

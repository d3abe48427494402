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
  // Ratios of the last steps: energy released over the energy expected from stress intensity factors.
  std::vector<double> energy_ratios{};
  // Distance ahead of the place at which evenly spread bonds would end, of which the crack has cut as much stiffness:
  // there the tip acts. Known of initial cracks that are felt where they are described, until they grow [m].
  std::optional<double> even_ahead{};
};

}  // namespace bempd::fracture

#include <algorithm>
#include <cmath>

#include "fracture/line/line_steps.hpp"

namespace bempd::fracture {

// Step of a tip in a given direction. The step is marked as one whose load comes from a trial step, so that its
// released energy does not correct later loads by the fit. A tip that bears no load gets the present load factor, and
// no energy counts as released.
std::optional<LineStep> step_towards(const Point& direction, const crack::TipId& tip, const LineSteps& steps,
                                     const BodyState& state, const std::optional<LineStep>& by_load) {
  const std::vector<GrowingTip>& tips = state.tips;
  const auto found =
      std::find_if(tips.begin(), tips.end(), [&](const GrowingTip& one) { return one.id == tip && !one.has_ended(); });
  if (found == tips.end()) return std::nullopt;
  const double present = state.load_factor;
  LineStep step = by_load.value_or(LineStep{});
  step.tip = static_cast<std::size_t>(found - tips.begin()), step.id = tip, step.law = found->law;
  step.angle = std::atan2(cross(found->direction, direction), found->direction.dot(direction));
  step.direction = direction;
  step.load_by_trial = true, step.after_step = 1, step.taken_energy = 0;
  step.is_loaded = by_load && step.ratio_at(present) > 0;
  if (!step.is_loaded) step.load_factor = present, step.constant = 1, step.growing = 0;
  step.path =
      steps.path().next(found->place, direction, steps.fields().law_of(*found).at(found->acts_at(), found->grown));
  return step.path.bonds.empty() ? std::nullopt : std::optional(step);
}

}  // namespace bempd::fracture

#include <algorithm>

#include "fracture/line/line_events.hpp"

namespace bempd::fracture {

// Tips of the crack lines in the order of the state's list. Tips that have not ended have the stress intensity factors
// of Williams' series fitted to the stress ahead.
std::vector<crack::Tip> LineEvents::fitted_tips() const {
  const BodyState& state = body_.state();
  std::vector<crack::Tip> found(state.tips.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const GrowingTip& tip = state.tips[k];
    found[k].id = tip.id, found[k].place = tip.place, found[k].direction = tip.direction;
    found[k].law = steps_.fields().growth_law(tip, tip.place);
    if (tip.has_ended()) continue;
    const AffineIntensity fit = steps_.fields().intensity_at(tip, state.displacement);
    if (found[k].law.asking.function)
      found[k].law.asking.t_stress = steps_.fields().t_stress_at(tip, state.displacement);
    found[k].factors = {{fit.one[0], fit.two[0]}, {fit.one[1], fit.two[1]}};
    found[k].load_rule = crack::LoadRule::fit, found[k].closed = steps_.fields().is_closed(tip, state.displacement);
    found[k].kink_angle = steps_.fields().kink_at(tip, state.displacement, state.load_factor);
  }
  return found;
}

// Tips that have not ended, with the range of load factors in which they do not grow. These load factors depend neither
// on the control of the load path nor on its start. Control::path is used because with it no load factor of growth is
// replaced by the present load factor.
std::vector<crack::Tip> LineEvents::tips(bool with_loads) {
  const BodyState& state = body_.state();
  std::vector<crack::Tip> found = fitted_tips();
  for (const bool upwards : {true, false}) {
    const LoadWay way{state.load_factor, upwards, Control::path};
    if (!with_loads) break;
    for (const LineStep& step : steps_.all(state.tips, state.displacement, way, &trials_, true)) {
      (upwards ? found[step.tip].range.highest : found[step.tip].range.lowest) = step.load_factor;
      if (!upwards) continue;
      found[step.tip].critical_kink_angle = step.angle, found[step.tip].load_error = step.error;
      if (step.load_by_sums)
        found[step.tip].load_rule = crack::LoadRule::factors, found[step.tip].factors = step.factors;
      if (step.load_by_trial) found[step.tip].load_rule = crack::LoadRule::energy;
    }
  }
  std::size_t left = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!state.tips[k].has_ended()) found[left++] = found[k];
  found.resize(left);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return found;
}

}  // namespace bempd::fracture

#include "fracture/window/line_forecast.hpp"

#include <algorithm>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

bool LineForecast::choose_place(WindowLocator& locator, const WindowOptions& options, const BodyState& state,
                                double load_factor) const {
  if (!state.displacement.col(0).isZero(0) || !(state.load_factor >= 0)) return false;
  std::vector<WindowLocator::PathAhead> paths;
  const LoadWay load_way{state.load_factor, true, options.control};
  const std::vector<LineStep> steps = lines_.all(state.tips, state.displacement, load_way);
  if (needs_trial_step(steps, load_way)) return false;
  for (const LineStep& step : steps) {
    if (!LineSteps::is_driven(step, load_way, load_factor)) continue;
    const GrowingTip& tip = state.tips[step.tip];
    const pd::TipLaw& law = lines_.fields().law_of(tip);
    const Point& from = tip.place;
    const double length = std::max(step.path.length, WindowSettings::least_path * law.spacing);
    paths.push_back({from, step.direction, law.horizon, {}});
    paths.back().bonds = lines_.path().across(from, from + length * step.direction, law.horizon);
  }
  return locator.choose(paths, options.ahead);
}

void LineForecast::begin(const coupling::Condensation& condensation, const WindowSolver& window,
                         const std::vector<GrowingTip>& tips) {
  condensation_ = &condensation, window_ = &window;
  tips_ = tips;
  note_displacement();
  certificate_.emplace(body_.system(), condensation, body_.response().ratios(), lines_);
}

void LineForecast::note_displacement() { near_tips_ = displacement_near(tips_); }

Affine LineForecast::displacement_near(const std::vector<GrowingTip>& tips) const {
  return condensation_->displacement_at(lines_.fields().nodes_asked(tips), window_->displacement());
}

std::optional<LineSteps::Choice> LineForecast::choose(double from, Control control, ForecastEvent& foreseen) const {
  const LoadWay way{from, true, control};
  LineSteps::Choice choice = lines_.choose(tips_, near_tips_, way);
  if (!choice.first || choice.needs_trial_step) return std::nullopt;
  const double at = choice.load_factor;
  if (!(at >= 0) || (from > 0 && !LineSteps::is_driven(*choice.first, way, WindowSettings::surely_driven * from)))
    return std::nullopt;
  foreseen.event = lines_.event_of(*choice.first, at);
  // A tip counts as guarding the bonds beside it from breaking by themselves only if the load surely drives it. If the
  // whole body did not count the tip, one of these bonds could break there before the steps.
  foreseen.growing = lines_.guarded(choice.steps, tips_, way, WindowSettings::surely_driven * std::max(at, from));
  return choice;
}

void LineForecast::complete_step(const LineSteps::Choice& line, ForecastEvent& foreseen) {
  foreseen.outcome.ties = line.ties;
  const auto displacement = [&](const auto& tips) -> const Affine& { return near_tips_ = displacement_near(tips); };
  foreseen.outcome.extensions = {lines_.growth().complete_step(*line.first, foreseen.event,
                                                               foreseen.outcome.released_energy, displacement, tips_)};
  foreseen.tips = tips_;
}

std::vector<WindowNarrowing::Reach> LineForecast::reaches() const {
  std::vector<WindowNarrowing::Reach> tips;
  for (const GrowingTip& tip : tips_)
    if (!tip.has_ended()) tips.push_back({tip.place, lines_.fields().law_of(tip).horizon});
  return tips;
}

int LineForecast::steps_as_foreseen(const std::vector<ForecastEvent>& events, const std::vector<Affine>& states) const {
  if (!lines_.fields().laws().more_begin) return static_cast<int>(events.size());
  std::vector<LineCertificate::Step> steps;
  for (const ForecastEvent& e : events) steps.push_back({e.event.load_factor, e.growing, &e.event.changes});
  return certificate_->first_break(states, steps);
}

}  // namespace bempd::fracture

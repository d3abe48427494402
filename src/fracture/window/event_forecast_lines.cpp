// Steps of crack lines in a window.
#include <algorithm>
#include <cmath>

#include "fracture/window/event_forecast.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

// Chooses a window that is large enough for the next steps of the crack tips.
bool EventForecast::choose_place_of_lines(const BodyState& state, double load_factor) {
  if (!state.displacement.col(0).isZero(0) || !(state.load_factor >= 0)) return false;
  std::vector<WindowLocator::Way> ways;
  const LoadWay load_way{state.load_factor, true, options_.control};
  const std::vector<LineStep> steps = lines_->all(state.tips, state.displacement, load_way);
  if (need_body(steps, load_way)) return false;
  for (const LineStep& step : steps) {
    if (!LineSteps::is_driven(step, load_way, load_factor)) continue;
    const GrowingTip& tip = state.tips[step.tip];
    const pd::TipLaw& law = lines_->law_of(tip);
    const Point& from = tip.place;
    const double length = std::max(step.way.length, WindowSettings::least_way * law.spacing);
    ways.push_back({from, step.direction, law.horizon, {}});
    ways.back().bonds = lines_->across(from, from + length * step.direction, law.horizon);
  }
  return locator_.choose(ways, options_.ahead);
}

void EventForecast::begin_steps(const BodyState& state) {
  tips_ = state.tips;
  near_tips_ = displacement_near(tips_);
  line_certificate_ = std::make_unique<LineCertificate>(system_, *condensation_, body_.ratios(), *lines_);
}

Affine EventForecast::displacement_near(const std::vector<GrowingTip>& tips) const {
  return condensation_->displacement_at(lines_->nodes_asked(tips), window_->displacement());
}

std::optional<LineSteps::Choice> EventForecast::choose_step(double from, ForecastEvent& foreseen) const {
  const std::vector<GrowingTip>& tips = last_tips();
  const LoadWay way{from, true, options_.control};
  LineSteps::Choice choice = lines_->choose(tips, near_tips_, way);
  if (!choice.first || choice.needs_body) return std::nullopt;
  const double at = choice.load_factor;
  if (!(at >= 0) || (from > 0 && !LineSteps::is_driven(*choice.first, way, WindowSettings::surely_driven * from)))
    return std::nullopt;
  foreseen.event = lines_->event_of(*choice.first, at);
  // A tip exempts the bonds beside it from the proof only if it is surely driven at this load factor: another bond
  // might otherwise break before all steps.
  foreseen.growing = lines_->guarded(choice.steps, tips, way, WindowSettings::surely_driven * std::max(at, from));
  return choice;
}

// Moves the tip of a line after its step has been performed in the window.
void EventForecast::take_step(const LineSteps::Choice& line, ForecastEvent& foreseen) {
  foreseen.tips = last_tips();
  foreseen.outcome.ties = line.ties;
  const auto displacement = [&](const auto& tips) -> const Affine& { return near_tips_ = displacement_near(tips); };
  foreseen.outcome.extensions = {
      lines_->take(*line.first, foreseen.event, foreseen.outcome.released_energy, displacement, foreseen.tips)};
}

void EventForecast::narrow(double load_factor) {
  if (!lines_) {
    narrowing_.narrow(*window_, condensation_->dofs(), load_factor);
    return;
  }
  std::vector<WindowNarrowing::Reach> tips;
  for (const GrowingTip& tip : last_tips())
    if (!LineSteps::has_ended(tip)) tips.push_back({tip.place, lines_->law_of(tip).horizon});
  narrowing_.narrow(*window_, condensation_->dofs(), tips);
}

// Number of computed events before which no bond away from the tips breaks; all of them if no crack can begin.
int EventForecast::steps_as_foreseen() const {
  if (!lines_->laws().more_begin) return static_cast<int>(events_.size());
  std::vector<LineCertificate::Step> steps;
  for (const ForecastEvent& e : events_) steps.push_back({e.event.load_factor, e.growing, &e.event.changes});
  return line_certificate_->first_break(states_, steps);
}

Affine EventForecast::whole_in(int state) const {
  return certificate_ ? certificate_->last_displacement(state) : condensation_->displacement(states_[state]);
}

}  // namespace bempd::fracture

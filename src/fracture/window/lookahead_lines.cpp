// Steps of lines in a window.
#include <algorithm>
#include <cmath>

#include "fracture/window/lookahead.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

// Where the next ways are kept for a while.
bool Lookahead::choose_place_of_lines(const BodyState& state, double load_factor) {
  if (!state.displacement.col(0).isZero(0) || !(state.load_factor >= 0)) return false;
  std::vector<WindowPlace::Way> ways;
  const LoadWay load_way{state.load_factor, true, options_.control};
  for (const LineStep& step : lines_->all(state.tips, state.displacement, load_way)) {
    if (!LineSteps::is_driven(step, load_way, load_factor)) continue;
    const GrowingTip& tip = state.tips[step.tip];
    const pd::TipLaw& law = lines_->law_of(tip);
    const Point& from = tip.place;
    const double length = std::max(step.way.length, WindowSettings::least_way * law.spacing);
    ways.push_back({from, step.direction, law.horizon, {}});
    ways.back().bonds = lines_->across(from, from + length * step.direction, law.horizon);
  }
  return place_.choose(ways, options_.ahead);
}

void Lookahead::begin_steps(const BodyState& state) {
  tips_ = state.tips;
  near_tips_ = displacement_near(tips_);
  away_from_tips_ = std::make_unique<AwayFromTips>(system_, *condensation_, whole_ratios_, *lines_);
}

Affine Lookahead::displacement_near(const std::vector<GrowingTip>& tips) const {
  return condensation_->displacement_at(lines_->nodes_asked(tips), window_->displacement());
}

std::optional<LineStep> Lookahead::choose_step(double from, ForeseenEvent& foreseen) const {
  const std::vector<GrowingTip>& tips = last_tips();
  const LoadWay way{from, true, options_.control};
  const std::vector<LineStep> steps = lines_->all(tips, near_tips_, way);
  const auto [first, ties] = LineSteps::first_of(steps, tips, way);
  if (!first) return std::nullopt;
  const double at = way.place_of(first->load_factor);
  if (!(at >= 0) || (from > 0 && !LineSteps::is_driven(*first, way, WindowSettings::surely_driven * from)))
    return std::nullopt;
  foreseen.event = {at, first->ratio_at(at), first->load_factor, {}};
  foreseen.ties = ties;
  for (const int bond : first->way.bonds) foreseen.event.changes.push_back(system_.terms().breaking(bond));
  // Another bond may come before all steps: where that might count, none is spared.
  for (const LineStep& step : steps)
    if (LineSteps::is_driven(step, way, WindowSettings::surely_driven * std::max(at, from)))
      foreseen.growing.push_back(tips[step.tip]);
  return *first;
}

// After its event in the window.
void Lookahead::take_step(const LineStep& step, ForeseenEvent& foreseen) {
  const Event& event = foreseen.event;
  foreseen.tips = last_tips();
  lines_->move(step, foreseen.tips);
  near_tips_ = displacement_near(foreseen.tips);
  foreseen.extensions = {
      lines_->remember(step, event.ratio, foreseen.released, near_tips_, event.load_factor, foreseen.tips)};
}

void Lookahead::narrow(double load_factor) {
  if (!lines_) {
    narrowing_.narrow(*window_, condensation_->dofs(), load_factor);
    return;
  }
  std::vector<Narrowing::Reach> tips;
  for (const GrowingTip& tip : last_tips())
    if (!LineSteps::has_ended(tip)) tips.push_back({tip.place, lines_->law_of(tip).horizon});
  narrowing_.narrow(*window_, condensation_->dofs(), tips);
}

// How many of the events come before a bond away from tips breaks; where nothing begins there, all.
int Lookahead::steps_as_foreseen() const {
  if (!lines_->laws().more_begin) return static_cast<int>(events_.size());
  std::vector<AwayFromTips::Step> steps;
  for (const ForeseenEvent& e : events_) steps.push_back({e.event.load_factor, e.growing, &e.event.changes});
  return away_from_tips_->first_break(states_, steps);
}

Affine Lookahead::whole_in(int state) const {
  return certificate_ ? certificate_->last_displacement(state) : condensation_->displacement(states_[state]);
}

}  // namespace bempd::fracture

#include <algorithm>
#include <cmath>

#include "model/extension_end.hpp"
#include "model/fatigue_run.hpp"

// Plan of a step of growth by cycles: how far each tip grows.
namespace bempd::model {

namespace {

// Largest length of a step, if the tip approaches an edge, a hole or another crack: length_over_clearance times the
// distance that is left, but at least least_step times the tip's size (size_of()), because ever shorter steps would
// never arrive at the obstacle.
constexpr double length_over_clearance = 0.25, least_step = 0.02;

}  // namespace

void FatigueRun::find_rates() {
  rates_.clear();
  for (std::size_t t = 0; t < front_.size(); ++t) rates_.push_back(crack::mean_rate(without_growth(t), 0, program_));
}

// Data of a tip for a step in which the tip does not grow.
crack::TipOnStep FatigueRun::without_growth(std::size_t tip) const {
  const FrontTip& of = front_[tip];
  crack::TipOnStep one;
  one.tip = of.id(), one.law = of.law, one.before = of.levels;
  one.length = length_of_crack(tip);
  one.from = one.to = of.values.place;
  one.critical = {of.critical};
  one.overload = overloads_.of(one.tip);
  return one;
}

// Length of the crack of a tip, measured between the effective tips at its ends [m].
double FatigueRun::length_of_crack(std::size_t tip) const {
  const int crack = front_[tip].values.crack;
  double length = length_of(cracks_[static_cast<std::size_t>(crack) - 1]);
  for (const FrontTip& one : front_)
    if (one.values.crack == crack) length += one.effective_tip_ahead;
  return length;
}

// Length of the crack of a tip by the cycles so far [m]; growth of crack lines that waits until it fills a spacing is
// included.
double FatigueRun::length_by_cycles(std::size_t tip) const {
  double length = length_of_crack(tip);
  for (std::size_t t = 0; t < front_.size(); ++t)
    if (is_line(t) && front_[t].values.crack == front_[tip].values.crack) length += waiting_.of(front_[t].id());
  return length;
}

// Size of a tip [m]: the tip's share of its crack's length. The growing ends of a crack share the length in proportion
// to their growth rates.
double FatigueRun::size_of(std::size_t tip) const {
  double sum = 0;
  for (std::size_t t = 0; t < front_.size(); ++t)
    if (front_[t].values.crack == front_[tip].values.crack) sum += rates_[t];
  return sum > 0 ? length_of_crack(tip) * rates_[tip] / sum : length_of_crack(tip);
}

double FatigueRun::longest(std::size_t tip) const {
  const regions::TipValues& at = front_[tip].values;
  const double size = size_of(tip);
  const double clearance = clearance_of_tip(model_.scene(), cracks_, at.crack, at.end);
  const double length = std::min(step_.share() * size, std::max(length_over_clearance * clearance, least_step * size));
  return std::max(length, lengthening_.growth_increment(at));
}

// Plans a step; empty if no tip grows by more than rounding. If few cycles are left, the lengths are at most the growth
// in these cycles at the present rates, with room for rising rates.
std::optional<FatigueRun::Plan> FatigueRun::plan() const {
  constexpr double room = 1.3;
  Plan plan;
  double cycles = FatigueOptions::unlimited;
  for (std::size_t t = 0; t < front_.size(); ++t) {
    if (!(rates_[t] > 0)) continue;
    const double own = longest(t) / rates_[t];
    if (own < cycles) cycles = own, plan.leader = t;
  }
  if (std::isinf(cycles)) return std::nullopt;
  cycles = std::min(cycles, room * cycles_left());
  const std::vector<double> ahead = waiting_.of(front_);
  for (std::size_t t = 0; t < front_.size(); ++t) plan.lengths.push_back(std::max(0.0, cycles * rates_[t] + ahead[t]));
  if (plan.lengths[plan.leader] < tiny_growth * size_of(plan.leader)) return std::nullopt;
  keep_within_length(plan);
  return plan;
}

// Whether a crack line is not extended in a trial, because the cycles end before the line has grown by half a spacing.
bool FatigueRun::waits(const Trial& trial, std::size_t tip) const {
  return trial.cycles.end != crack::CyclesEnd::growth &&
         trial.cycles.growth[tip] < 0.5 * lengthening_.growth_increment(front_[tip].values);
}

// Tip with boundary elements that leads the step in place of a crack line that waits; empty if no such tip grows by
// more than rounding.
std::optional<std::size_t> FatigueRun::leader_instead(const Trial& trial) const {
  for (std::size_t t = 0; t < front_.size(); ++t)
    if (!is_line(t) && trial.cycles.growth[t] > tiny_growth * size_of(t)) return t;
  return std::nullopt;
}

// Shortens a plan so that no crack becomes longer than options_.most_length. A tip whose crack reaches this length
// becomes the leader, because the leader's length is met exactly.
void FatigueRun::keep_within_length(Plan& plan) const {
  double share = 1;
  for (std::size_t t = 0; t < front_.size(); ++t) {
    double growth = 0;
    for (std::size_t other = 0; other < front_.size(); ++other)
      if (front_[other].values.crack == front_[t].values.crack) growth += plan.lengths[other];
    const double own = growth > 0 ? (options_.most_length - length_of_crack(t)) / growth : 1;
    if (own < share && plan.lengths[t] > 0) share = own, plan.leader = t;
  }
  for (double& length : plan.lengths) length *= std::max(0.0, share);
}

}  // namespace bempd::model

#include "model/fatigue_run.hpp"

#include <algorithm>
#include <cmath>

#include "crack/cannot_grow.hpp"

namespace bempd::model {

namespace {

// Least growth for which a tip's crack is extended: the smaller of least_growth times the tip's size and `slow` times
// the growth of the leader (tip that sets the length of the step). Smaller growth is carried over to later steps.
constexpr double least_growth = 0.005, slow = 0.05;

// Turn of a tip in a step [rad]. Above `turns` the step is repeated with the direction of the chord of its curved path;
// above turns_too_much the step is halved.
constexpr double turns = 0.01, turns_too_much = 0.35;

// Largest difference between the length of an extension and the tip's growth in the cycles of the step, as a share of
// the length: off_at_first for the first trial of a step, and for the leader in all trials; off_later for the other
// tips in repeated trials.
constexpr double off_at_first = 0.005, off_later = 0.03;

constexpr int most_trials = 5;

constexpr double rounding = 1e-9;

}  // namespace

FatigueRun::FatigueRun(Model& model, CrackLengthening& lengthening, const FatigueOptions& options)
    : model_(model),
      lengthening_(lengthening),
      options_(options),
      levels_(options.blocks),
      program_(levels_.blocks()),
      reader_(model, lengthening, levels_),
      step_(options) {}

FatigueReport FatigueRun::run() {
  if (!levels_.combine_cases()) lengthening_.go_to(levels_.factor(levels_.highest()));
  place_ = program_.place_after(options_.first_cycle);
  report_.cycles = options_.first_cycle;
  find_front();
  warn_of_short_lines(front_, cracks_, lengthening_);
  if (options_.first_cycle > 0) {
    overloads_.take_up(model_.fatigue().overloads(), front_, cracks_, options_.first_cycle);
    find_rates();
  }
  waiting_.take_up(model_.fatigue().overloads(), front_, cracks_);
  record();
  while (step()) lengthening_.report_progress();
  lengthening_.leave_trial();
  report_.error = step_.error(report_.cycles - options_.first_cycle, report_.steps > 0);
  return report_;
}

void FatigueRun::find_front() {
  const std::vector<regions::TipValues> tips = lengthening_.tips();
  require(!tips.empty(), crack::no_free_tip);
  front_ = reader_.front(tips, nullptr);
  cracks_ = lengthening_.cracks();
  require(!front_.empty(),
          "no material with a tip has a law of growth by cycles; give it one with bempd_set_growth_rate()");
  find_rates();
}

// Makes a step; returns false if the run is over. A step is halved if a tip turns too much, if the error of the counted
// cycles is too large, or if no scene with the longer cracks is possible.
bool FatigueRun::step() {
  constexpr int most_halvings = 4;
  if (report_.steps >= options_.most_steps) return end_by(FatigueEnd::steps);
  if (lengthening_.stop_requested()) return end_by(FatigueEnd::requested);
  for (std::size_t t = 0; t < front_.size(); ++t)
    if (length_by_cycles(t) >= options_.most_length * (1 - rounding)) return end_by(FatigueEnd::length, front_[t].id());
  for (int halvings = 0;; ++halvings) {
    const std::optional<Plan> plan = this->plan();
    if (!plan) return pass_without_growth();
    try {
      std::size_t leader = plan->leader;
      Trial trial = compute_step(*plan);
      if (is_line(leader) && waits(trial, leader)) {
        const std::optional<std::size_t> other = leader_instead(trial);
        if (!other) return pass(trial.cycles);
        leader = *other, trial = compute_step({trial.cycles.growth, leader});
      }
      if (is_too_short(trial, leader)) return pass(trial.cycles);
      const bool is_last = halvings == most_halvings;
      const bool may_stand = is_last || largest_turn(trial) <= turns_too_much;
      if (may_stand && choose_step(trial, leader, is_last)) return accept(std::move(trial), leader);
    } catch (const Error& error) {
      // The crack of the leading tip ends where the remaining ligament is too thin for a solution, or where no scene
      // with the longer crack is possible.
      const bool has_no_scene = dynamic_cast<const crack::CannotGrow*>(&error) != nullptr;
      if (!has_no_scene && error.failure() != Failure::unsolvable) throw;
      if (halvings == most_halvings) {
        lengthening_.tell(error.what());
        return end_by(FatigueEnd::tip_stopped, front_[plan->leader].id());
      }
    }
    step_.halve();
  }
}

// Computes a step by repeated trials, until the growth of all tips belongs to one number of cycles. If tips turn much
// in the first trial, the second trial begins with directions turned by half of these angles.
FatigueRun::Trial FatigueRun::compute_step(const Plan& plan) {
  std::vector<double> angles;
  for (const FrontTip& tip : front_) angles.push_back(tip.angle);
  Trial now = trial(plan.lengths, std::move(angles), plan.leader);
  for (int trials = 1; trials < most_trials && !is_too_short(now, plan.leader); ++trials) {
    const bool turns_on = trials == 1 && largest_turn(now) > turns;
    if (is_line(plan.leader) && waits(now, plan.leader)) break;
    if (!turns_on && !differs_from_cycles(now, plan.leader, trials == 1 ? off_at_first : off_later)) break;
    std::vector<double> turned = now.angles;
    for (std::size_t t = 0; turns_on && t < turned.size(); ++t) turned[t] += 0.5 * turn(now, t);
    now = trial(now.cycles.growth, std::move(turned), plan.leader);
  }
  return now;
}

// Whether the cycles of a step end before the leading tip has grown by more than rounding.
bool FatigueRun::is_too_short(const Trial& trial, std::size_t leader) const {
  return trial.cycles.end != crack::CyclesEnd::growth && trial.cycles.growth[leader] < tiny_growth * size_of(leader);
}

FatigueRun::Trial FatigueRun::trial(std::vector<double> lengths, std::vector<double> angles, std::size_t leader) {
  Trial trial;
  trial.lengths = std::move(lengths), trial.angles = std::move(angles);
  std::vector<Lengthened> grow;
  for (std::size_t t = 0; t < front_.size(); ++t)
    if (t == leader || trial.lengths[t] > std::max(std::min(least_growth * size_of(t), slow * trial.lengths[leader]),
                                                   0.5 * lengthening_.growth_increment(front_[t].values)))
      grow.push_back({front_[t].values, trial.lengths[t], trial.angles[t], reader_.turns_by_itself(front_[t])});
  trial.longer = lengthening_.lengthened(grow);
  std::vector<regions::TipValues> tips = trial.longer.grown.tips;
  std::erase_if(tips, [&](const auto& tip) { return tip_in(front_, tip.id()) == nullptr; });
  trial.after = reader_.front(tips, &trial.longer);
  trial.on_step = on_step(trial);
  const crack::CycleIntegration integration(program_, trial.on_step);
  trial.cycles = integration.run(place_, waiting_.of(front_), leader, trial.on_step[leader].growth, cycles_left());
  return trial;
}

std::vector<crack::TipOnStep> FatigueRun::on_step(const Trial& trial) const {
  const std::vector<crack::Extension>& extensions = trial.longer.grown.growth.extensions;
  std::vector<crack::TipOnStep> all;
  for (std::size_t t = 0; t < front_.size(); ++t) {
    crack::TipOnStep one = without_growth(t);
    for (const crack::Extension& e : extensions) {
      const FrontTip *from = tip_in(front_, e.tip()), *to = tip_in(trial.after, e.tip());
      const double length = e.length + (from && to ? to->effective_tip_ahead - from->effective_tip_ahead : 0);
      if (e.crack == one.tip.crack) one.crack_growth += length;
      if (e.tip() == one.tip) one.growth = length, one.to = Point(e.x, e.y);
    }
    const FrontTip* after = tip_in(trial.after, one.tip);
    if (after) one.after = after->levels;
    one.critical = reader_.critical_along(front_[t], after, one.to);
    if (const auto last = last_growth_.find(one.tip); last != last_growth_.end())
      one.past_growth = last->second, one.past = last_levels_.at(one.tip);
    all.push_back(std::move(one));
  }
  return all;
}

double FatigueRun::turn(const Trial& trial, std::size_t tip) const {
  const FrontTip* after = tip_in(trial.after, front_[tip].id());
  const bool is_curve = after && !after->values.directions;  // with a fracture energy by direction, turns are kinks
  return is_curve && trial.on_step[tip].growth > 0 && rates_[tip] > 0 ? after->angle : 0;
}

double FatigueRun::largest_turn(const Trial& trial) const {
  double largest = 0;
  for (std::size_t t = 0; t < front_.size(); ++t) largest = std::max(largest, std::abs(turn(trial, t)));
  return largest;
}

// Whether the growth of any tip in the cycles of a trial differs from the tip's length in the trial by more than
// `share` of that length. A tip that has ended cannot grow further, so its larger growth does not count.
bool FatigueRun::differs_from_cycles(const Trial& trial, std::size_t leader, double share) const {
  for (std::size_t t = 0; t < front_.size(); ++t) {
    const crack::TipOnStep& tip = trial.on_step[t];
    const double difference = trial.cycles.growth[t] - tip.growth;
    if (!(tip.growth > 0) || (tip.after.empty() && difference > 0)) continue;
    const double allowed = t == leader ? off_at_first : share,
                 increment = lengthening_.growth_increment(front_[t].values);
    if (std::abs(difference) > std::max(allowed * tip.growth, 0.51 * increment)) return true;
  }
  return false;
}

bool FatigueRun::choose_step(const Trial& trial, std::size_t leader, bool must_stand) {
  // Factors K in lattices scatter from step to step, so their changes do not show the error of the cycles.
  if (lengthening_.growth_increment(front_[leader].values) > 0) return true;
  const crack::TipOnStep& tip = trial.on_step[leader];
  const double so_far = report_.cycles - options_.first_cycle + trial.cycles.cycles;
  return step_.choose(tip, rates_[leader], crack::mean_rate(tip, tip.growth, program_), trial.cycles.cycles, so_far,
                      must_stand);
}

bool FatigueRun::accept(Trial trial, std::size_t leader) {
  const std::vector<crack::Extension> extensions = trial.longer.grown.growth.extensions;
  lengthening_.go_on_in(std::move(trial.longer));
  ++report_.steps;
  for (std::size_t t = 0; t < front_.size(); ++t) {
    const crack::TipOnStep& tip = trial.on_step[t];
    waiting_[tip.tip] = t == leader && !is_line(t) ? 0 : trial.cycles.growth[t] - tip.growth;
    grown_[tip.tip] += tip.growth;
    last_growth_[tip.tip] = tip.growth, last_levels_[tip.tip] = tip.before;
    report_.growth += tip.growth;
    overloads_.set_after_step(tip, trial.cycles.overloads[t]);
  }
  report_.cycles += trial.cycles.cycles;
  place_ = trial.cycles.place;
  front_ = std::move(trial.after);
  cracks_ = lengthening_.cracks();
  find_rates();
  record();
  for (const crack::Extension& e : extensions) {
    if (e.state == crack::TipState::at_interface) return end_by(FatigueEnd::tip_stopped, e.tip());
    if (e.has_ended()) return end_by(FatigueEnd::tip_ended, e.tip());
  }
  return !is_over(trial.cycles);
}

bool FatigueRun::pass(const crack::CyclesOnStep& cycles) {
  lengthening_.leave_trial();
  report_.cycles += cycles.cycles;
  for (std::size_t t = 0; t < front_.size(); ++t)
    overloads_.set(front_[t].id(), cycles.overloads[t]), waiting_[front_[t].id()] = cycles.growth[t];
  place_ = cycles.place;
  return !is_over(cycles);
}

// Counts the cycles that are left, because no tip grows by more than rounding. No crack is extended.
bool FatigueRun::pass_without_growth() {
  std::vector<crack::TipOnStep> here;
  for (std::size_t t = 0; t < front_.size(); ++t) here.push_back(without_growth(t));
  const crack::CycleIntegration integration(program_, here);
  return pass(integration.run(place_, waiting_.of(front_), 0, FatigueOptions::unlimited, cycles_left()));
}

bool FatigueRun::is_over(const crack::CyclesOnStep& cycles) {
  using crack::CyclesEnd;
  if (cycles.end == CyclesEnd::cycles) {
    report_.cycles = options_.most_cycles;
    return !end_by(FatigueEnd::cycles);
  }
  if (cycles.end == CyclesEnd::none_grows) return !end_by(FatigueEnd::none_grows);
  if (cycles.end == CyclesEnd::critical) return !end_by(FatigueEnd::critical, front_[cycles.tip].id());
  if (cycles.end == CyclesEnd::net_section) return !end_by(FatigueEnd::net_section, front_[cycles.tip].id());
  return false;
}

bool FatigueRun::end_by(FatigueEnd end, const crack::TipId& tip) {
  report_.end = end, report_.tip = tip;
  return false;
}

void FatigueRun::record() {
  for (std::size_t t = 0; t < front_.size(); ++t) {
    const FrontTip& tip = front_[t];
    FatigueRecord record;
    record.step = report_.steps,
    record.event = report_.steps > 0 ? lengthening_.scene().evolution->progress().events : 0;
    record.tip = tip.id(), record.cycles = report_.cycles;
    record.length = length_by_cycles(t), record.growth = grown_[tip.id()];
    record.place = tip.values.place;
    const crack::LevelFactors &high = tip.levels[tip.high], &low = tip.levels[tip.low];
    record.high = high.factors, record.low = low.factors;
    record.highest = high.equivalent, record.lowest = low.equivalent;
    record.rate = rates_[t];
    records_.push_back(record);
  }
}

}  // namespace bempd::model

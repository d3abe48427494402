#include "fracture/crack_evolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "error.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/resistance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

namespace {

// Largest number of contact events at one load factor. After each of them all faces agree with their gaps; more of them
// mean that faces open and close without end.
constexpr int most_events = 1000;

// Detects the end of an equilibrium path at contact events, where the path may reverse its direction in the load
// factor. If it reverses twice at one load factor it cannot continue: it would lead down with the contact state that
// holds above, and up with the one that holds below.
class Turns {
 public:
  // Records a contact event; returns false if the path ends there.
  bool pass(const Event& event) {
    const bool here = event.load_factor == load_factor_;
    events_ = here ? events_ + 1 : 1;
    if (events_ > most_events) fail(Failure::convergence, "faces of cracks open and close without an end");
    turns_ = here ? turns_ + (event.goes_down != down_ ? 1 : 0) : 0;
    load_factor_ = event.load_factor, down_ = event.goes_down;
    return turns_ < 2;
  }

 private:
  double load_factor_ = std::numeric_limits<double>::quiet_NaN();
  bool down_ = false;
  int turns_ = 0, events_ = 0;
};

void require_fewer_events(std::int64_t events, std::int64_t most) {
  if (events < most) return;
  fail(Failure::convergence, most,
       " events happened in this step, as many as the option stepping.max_events allows; raise it to go on");
}

}  // namespace

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               std::vector<std::vector<int>> reaction_dofs, ContactPlan contact)
    : system_(system),
      body_(system, positions, std::move(critical_stretch), cut, std::move(reaction_dofs), std::move(contact), state_),
      sources_(body_, cut) {
  state_.work = body_.energy_at_rest();
}

void CrackEvolution::grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips) {
  state_.tips = std::move(tips);
  lengths_ = laws.of_crack;
  sources_.grow_lines(std::move(laws));
}

bool CrackEvolution::energies_are_lost() const {
  const double displacement = state_.total_displacement.lpNorm<Eigen::Infinity>();
  const double force = state_.total_force.lpNorm<Eigen::Infinity>();
  return displacement > 0 && force > 0 && !std::isnormal(displacement * force);
}

StopReason CrackEvolution::advance(double target, Goal goal, const SteppingOptions& options,
                                   const std::function<void(const EvolutionState&)>& on_event,
                                   const std::function<void()>& on_end) {
  sources_.refresh();
  sources_.freeze(options.frozen);
  sources_.go_on();
  sources_.begin_call();
  const Start start = this->start();
  try {
    const StopReason reason = run(target, goal, options, on_event);
    if (reason == StopReason::growth) {
      start_ = start;
      return reason;
    }
    const bool changed = state_.events != start.sums.events || state_.contact_switches != start.sums.contact_switches;
    if (options.leaves_fresh && changed) synchronize();
    if (on_end) on_end();
    sources_.drop_mark();
    return reason;
  } catch (...) {
    return_to(start);
    throw;
  }
}

StopReason CrackEvolution::run(double target, Goal goal, const SteppingOptions& options,
                               const std::function<void(const EvolutionState&)>& on_event) {
  const std::int64_t events_before = state_.events - options.events_so_far;
  Turns turns;
  if (!state_.in_equilibrium) {
    sources_.mark();
    find_equilibrium();
  }
  for (;;) {
    if (goal == Goal::separation && state_.separated) return StopReason::separated;
    if (options.stop && options.stop->load(std::memory_order_relaxed)) {
      end_step();
      return StopReason::requested;
    }
    const Event* next = sources_.next(target, options);
    if (has_come_apart(next, target, options) && goal != Goal::load_factor) return StopReason::separated;
    if (const std::optional<StopReason> reason = next ? std::nullopt : why_there_is_none(goal, options)) {
      end_step();
      return *reason;
    }
    const bool upwards = target >= state_.load_factor;
    if (!next || (upwards ? next->load_factor > target : next->load_factor < target)) break;
    require_fewer_events(state_.events - events_before, options.max_events);
    sources_.mark();
    if (next->is_contact) {
      if (!turns.pass(*next)) {
        end_step();
        return StopReason::no_admissible_load;
      }
      pass(sources_.perform());
      continue;
    }
    if (next->is_growth) return go_to_growth(*next);
    turns = {};
    const bool increments = options.mode == SteppingMode::increments;
    if (!perform(*next, options, increments && state_.events > events_before)) {
      end_step();
      return StopReason::no_equilibrium;
    }
    if (on_event) on_event(state_);
    if (goal == Goal::next_event) return state_.separated ? StopReason::separated : StopReason::event;
  }
  sources_.mark();
  sources_.bring_up_to_date();
  state_.work = in_range(state_.work + body_.move_to(target));
  end_step();
  return state_.separated ? StopReason::separated : StopReason::load_factor;
}

// Reason for the end of a step when no event is left; empty if the step goes on to a load factor.
std::optional<StopReason> CrackEvolution::why_there_is_none(Goal goal, const SteppingOptions& options) {
  if (options.control == Control::path) {
    sources_.bring_up_to_date();
    const bool elements_rest = !options.elements || !crack::common_range(options.elements->tips()).is_empty();
    if (!elements_rest || body_.admissible().is_empty()) return StopReason::no_admissible_load;
  }
  return goal == Goal::load_factor ? std::nullopt : std::optional(StopReason::no_further_event);
}

// Whether the body is found to be separated now: the connection that carried the load has lost its resistance, and the
// remainder breaks only under larger loads, if at all.
bool CrackEvolution::has_come_apart(const Event* next, double target, const SteppingOptions& options) {
  if (state_.separated || !is_lost(state_.resistance, options.separation_share)) return false;
  // Bonds that exceed their critical stretch after an increment break in the next one, so separation is not judged yet.
  if (options.mode == SteppingMode::increments &&
      !body_.ratios().overstretched(system_.intact(), state_.load_factor).empty()) {
    return false;
  }
  if (next) {
    const double direction = target >= state_.load_factor ? 1 : -1;
    double farthest = direction * state_.load_factor;
    // The load factor may have been larger before on an equilibrium path.
    if (options.control == Control::path) {
      for (const HistoryEntry& line : state_.history) farthest = std::max(farthest, direction * line.load_factor);
    }
    if (direction * next->load_factor <= farthest) return false;
  }
  state_.separated = true;
  return true;
}

// Performs an event. With `keep_what_was_reached`, returns false if no equilibrium exists after it, and the state
// before it is restored: the event has then not happened.
bool CrackEvolution::perform(const Event& event, const SteppingOptions& options, bool keep_what_was_reached) {
  const auto perform_and_book = [&] {
    const double within_before = within(event.load_factor);
    Outcome outcome = sources_.perform();
    outcome.within_before = within_before;
    book(event, outcome, options);
  };
  if (!keep_what_was_reached) {
    perform_and_book();
    return true;
  }
  BodyState before = state_;
  const Start start = this->start();
  try {
    perform_and_book();
    return true;
  } catch (const Error& error) {
    if (error.failure() != Failure::unsolvable) throw;
    forget_lines(start);
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    sources_.refresh();
    return false;
  }
}

// Next bond that breaks by itself; bonds around the tips of crack lines are left out.
std::optional<NextBond> CrackEvolution::next_bond(bool upwards, Control control) {
  look();
  std::vector<char> intact = system_.intact();
  if (const LineSteps* lines = sources_.line_steps()) {
    if (!lines->laws().more_begin) return std::nullopt;
    for (const GrowingTip& tip : state_.tips) lines->spare(tip, intact);
  }
  const BondList bonds{body_.ratios(), intact};
  const std::optional<double> at = next_critical(bonds, {state_.load_factor, upwards, control});
  if (!at) return std::nullopt;
  const std::vector<int> most = most_critical(bonds, *at, 0, 0);
  if (most.empty()) return std::nullopt;
  return NextBond{most.front(), *at, body_.ratios().at(static_cast<std::size_t>(most.front()), state_.load_factor)};
}

void CrackEvolution::restore(EvolutionState state, std::optional<Continuation> continuation) noexcept {
  state_ = std::move(state);
  sources_.abandon();
  if (continuation) sources_.continue_with(std::move(*continuation));
}

void CrackEvolution::synchronize() {
  sources_.refresh();
  sources_.bring_up_to_date();
  sources_.forget();
  body_.update_faces();
  system_.bar_constraints({});  // they are found anew, as by a run that goes on from the state
  system_.forget_factor();
  system_.forget_places_met();
}

}  // namespace bempd::fracture

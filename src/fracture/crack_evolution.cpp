#include "fracture/crack_evolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "error.hpp"
#include "fracture/balance.hpp"
#include "fracture/other_tips.hpp"
#include "fracture/resistance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

namespace {

// Of faces at one load factor, each of which leaves all as they should be.
constexpr int most_events = 1000;

// Where faces close or open a path of equilibrium may turn. Where it turns back again at the same load factor the way
// on leads down with the faces as they are above it, and up with those below: there is none.
class Turns {
 public:
  // False if the path ends at this event of faces.
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
  sources_.go_on();
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

// Why no event is left, where that ends a step.
std::optional<StopReason> CrackEvolution::why_there_is_none(Goal goal, const SteppingOptions& options) {
  if (options.control == Control::path) {
    sources_.bring_up_to_date();
    const bool others_rest = !options.other_tips || options.other_tips->rest_somewhere();
    if (!others_rest || body_.admissible().is_empty()) return StopReason::no_admissible_load;
  }
  return goal == Goal::load_factor ? std::nullopt : std::optional(StopReason::no_further_event);
}

// Whether this is found now: the connection that carried the load has lost its resistance, and what is left breaks
// under larger loads only, if at all.
bool CrackEvolution::has_come_apart(const Event* next, double target, const SteppingOptions& options) {
  if (state_.separated || !is_lost(state_.resistance, options.separation_share)) return false;
  // In increments what is stretched too far waits for the end of the next one.
  if (options.mode == SteppingMode::increments &&
      !body_.ratios().overstretched(system_.intact(), state_.load_factor).empty()) {
    return false;
  }
  if (next) {
    const double direction = target >= state_.load_factor ? 1 : -1;
    double farthest = direction * state_.load_factor;
    // On a path of equilibrium the load factor has fallen since.
    if (options.control == Control::path) {
      for (const HistoryEntry& line : state_.history) farthest = std::max(farthest, direction * line.load_factor);
    }
    if (direction * next->load_factor <= farthest) return false;
  }
  state_.separated = true;
  return true;
}

// False if no equilibrium is left after the event, and what was reached before it is to be kept: then it did not
// happen.
bool CrackEvolution::perform(const Event& event, const SteppingOptions& options, bool keep_what_was_reached) {
  if (!keep_what_was_reached) {
    book(event, sources_.perform(), options);
    return true;
  }
  BodyState before = state_;
  const Start start = this->start();
  try {
    book(event, sources_.perform(), options);
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

// What loads give in an event beyond equilibrium, and bonds do not take: it sets the body in motion, and is neither
// released by breaking nor work of a quasi-static run.
double CrackEvolution::work_that_moves(const Event& event, const Outcome& outcome, const SteppingOptions& options) {
  if (options.mode != SteppingMode::events || !event.is_out_of_balance()) {
    state_.work_out_of_balance = 0;
    return 0;
  }
  const double given = std::max(0.0, state_.work_out_of_balance + outcome.work);
  const double moved = std::clamp(outcome.released_energy - outcome.bond_energy, 0.0, given);
  state_.work_out_of_balance = given - moved;
  return moved;
}

void CrackEvolution::book(const Event& event, const Outcome& outcome, const SteppingOptions& options) {
  const double moved = work_that_moves(event, outcome, options);
  state_.work += outcome.work_before;
  state_.work = in_range(state_.work + (outcome.work - moved));
  state_.released_energy = in_range(state_.released_energy + (outcome.released_energy - moved));
  state_.bond_energy = in_range(state_.bond_energy + outcome.bond_energy);
  ++state_.events;
  state_.broken_bonds += outcome.broken;
  state_.fragments += outcome.fragments;
  state_.contact_switches += outcome.switches;
  state_.ties += outcome.ties;
  book_lines(outcome, outcome.released_energy - moved);
  add(state_.resistance, event, outcome);
  if (is_separated(system_, outcome.unit_energy, state_.first_unit_energy)) state_.separated = true;
  HistoryEntry line;
  line.event = state_.events;
  line.stretch_ratio = event.ratio;
  line.stored_energy = outcome.stored_energy;
  line.critical_load_factor = event.critical_load_factor;
  line.critical_stored_energy = in_range(outcome.critical_stored_energy + within(event.critical_load_factor));
  line.residual = outcome.residual;
  write_line(line, outcome.energy_scale, outcome.reactions);
}

// On the way between two events, where nothing breaks.
void CrackEvolution::pass(const Outcome& outcome) {
  state_.work = in_range(state_.work + outcome.work_before);
  measure_work();
  state_.contact_switches += outcome.switches;
  // Where faces are all that holds the undamaged scene.
  if (state_.events == 0) state_.first_unit_energy = std::max(state_.first_unit_energy, body_.unit_energy());
  if (!outcome.comes_free) return;
  state_.work = in_range(state_.work + outcome.work);
  state_.released_energy = in_range(state_.released_energy + outcome.released_energy);
  state_.fragments += outcome.fragments;
  if (is_separated(system_, outcome.unit_energy, state_.first_unit_energy)) state_.separated = true;
}

void CrackEvolution::end_step() {
  sources_.bring_up_to_date();
  HistoryEntry line;
  line.stored_energy = body_.stored_energy();
  line.critical_load_factor = state_.load_factor;
  line.critical_stored_energy = in_range(line.stored_energy + within(state_.load_factor));
  line.residual = body_.residual();
  write_line(line, least_energy_scale(system_, state_.load_factor), body_.reactions());
}

void CrackEvolution::write_line(const HistoryEntry& known, double energy_scale, const std::vector<double>& reactions) {
  HistoryEntry line = known;
  line.total_broken_bonds = state_.broken_bonds;
  line.load_factor = state_.load_factor;
  line.stored_energy = in_range(line.stored_energy);
  line.released_energy = state_.released_energy;
  line.bond_energy = state_.bond_energy;
  const double difference = std::abs(state_.work - line.stored_energy - state_.released_energy);
  line.stored_energy = in_range(line.stored_energy + within(state_.load_factor));
  line.work = work();
  state_.largest_work = std::max(state_.largest_work, std::abs(line.work));
  const double scale = std::max(state_.largest_work, energy_scale);
  line.energy_balance_error = scale > 0 ? difference / scale : difference;
  if (!std::isfinite(line.energy_balance_error)) line.energy_balance_error = 0;  // of energies that are lost
  if (!Eigen::Map<const Eigen::VectorXd>(reactions.data(), static_cast<Eigen::Index>(reactions.size())).allFinite() ||
      !std::isfinite(line.load_factor) || !std::isfinite(line.stretch_ratio) || !std::isfinite(line.residual)) {
    fail_out_of_range();
  }
  require_balance(line.residual, system_.is_symmetric() ? line.energy_balance_error : 0);
  state_.worst_energy_balance_error = std::max(state_.worst_energy_balance_error, line.energy_balance_error);
  state_.residual = line.residual;
  state_.history.push_back(line);
  state_.reactions.insert(state_.reactions.end(), reactions.begin(), reactions.end());
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
  system_.bar_contacts({});  // they are found anew, as by a run that goes on from the state
  system_.forget_factor();
  system_.forget_places_met();
}

}  // namespace bempd::fracture

#include "fracture/crack_evolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"

namespace bempd::fracture {

using coupling::Affine;

namespace {

// Energies that no number can hold are told as the largest one, and Model warns of them.
double in_range(double energy) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::isnan(energy) ? largest : std::clamp(energy, -largest, largest);
}

void require_balance(double residual, double energy_balance_error) {
  if (residual > most_residual) {
    fail(Failure::unsolvable, "forces are out of balance by ", residual,
         " of the largest one: a part is held by next to nothing, or very slender; check supports and cracks");
  }
  if (energy_balance_error > most_imbalance) {
    fail(Failure::unsolvable, "work and energies differ by ", energy_balance_error,
         " of the largest work: a part is held by next to nothing, or very slender; check supports and cracks");
  }
}

}  // namespace

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               std::vector<std::vector<int>> reaction_dofs)
    : system_(system),
      body_(system, positions, std::move(critical_stretch), cut, std::move(reaction_dofs), state_),
      sources_(body_, cut) {
  state_.work = body_.energy_at_rest();
}

void CrackEvolution::grow_lines(std::vector<pd::TipLaw> laws, std::vector<GrowingTip> tips) {
  state_.tips = std::move(tips);
  sources_.grow_lines(std::move(laws));
}

void CrackEvolution::set_load(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within) {
  sources_.refresh();
  sources_.settle();
  body_.set_load(force, prescribed);
  work_within_ = work_within;
}

void CrackEvolution::take_over(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within) {
  sources_.refresh();
  sources_.settle();
  body_.take_over(force, prescribed);
  work_within_ = work_within;
}

void CrackEvolution::act_again(Loads loads) noexcept {
  body_.act_again(std::move(loads.acting));
  work_within_ = loads.work_within;
  sources_.abandon();
}

double CrackEvolution::within(double load_factor) const {
  const Eigen::Vector2d loads(1, load_factor);
  return 0.5 * loads.dot(work_within_ * loads);
}

double CrackEvolution::work() const { return in_range(state_.work + within(state_.load_factor)); }

void CrackEvolution::find_equilibrium() {
  sources_.refresh();
  if (state_.in_equilibrium) return;
  BodyState before = state_;
  try {
    LoadedBody::FirstEquilibrium found = body_.find_equilibrium();
    require_balance(body_.residual(), 0);
    held_ = std::move(found.held);
    state_.fragments += found.fragments;
    state_.work = in_range(state_.work + found.work);
  } catch (...) {
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    throw;
  }
}

// At constant loads a body's potential energy falls by what its cracks take; what the loads do follows from where they
// have come to.
void CrackEvolution::go_on_after_growth(CrackEvolution& before) {
  const EvolutionState& old = before.state();
  static_cast<Sums&>(state_) = old;
  state_.history = old.history;
  state_.reactions = old.reactions;
  state_.extensions = old.extensions;
  state_.load_factor = old.load_factor;
  state_.largest_force = old.largest_force;
  held_ = body_.find_equilibrium().held;
  const double f = state_.load_factor;
  const double work = body_.potential_of_loads() - before.body_.potential_of_loads() + within(f) - before.within(f);
  state_.work = in_range(state_.work + work);
  state_.released_energy =
      in_range(state_.released_energy + work + before.body_.stored_energy() - body_.stored_energy());
  ++state_.events;
  HistoryEntry line;
  line.event = state_.events;
  line.stretch_ratio = 1;
  line.stored_energy = body_.stored_energy();
  line.critical_stored_energy = in_range(line.stored_energy + within(f));
  line.critical_load_factor = state_.load_factor;
  line.residual = body_.residual();
  write_line(line, energy_scale_of_supports(system_, state_.load_factor), body_.reactions());
}

void CrackEvolution::book(const std::vector<CrackExtension>& extensions) {
  for (const CrackExtension& extension : extensions) {
    state_.extensions.push_back(extension);
    state_.extensions.back().event = state_.events;
  }
}

bool CrackEvolution::energies_are_lost() const {
  const double displacement = state_.total_displacement.lpNorm<Eigen::Infinity>();
  const double force = state_.total_force.lpNorm<Eigen::Infinity>();
  return displacement > 0 && force > 0 && !std::isnormal(displacement * force);
}

StopReason CrackEvolution::advance(double target, Goal goal, const SteppingOptions& options,
                                   const std::function<void(const EvolutionState&)>& on_event) {
  sources_.refresh();
  const Start start{state_, state_.history.size(), state_.reactions.size()};
  try {
    const StopReason reason = run(target, goal, options, on_event);
    sources_.drop_mark();
    return reason;
  } catch (...) {
    return_to(start);
    throw;
  }
}

StopReason CrackEvolution::run(double target, Goal goal, const SteppingOptions& options,
                               const std::function<void(const EvolutionState&)>& on_event) {
  const std::int64_t events_before = state_.events;
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
    if (!next && (goal != Goal::load_factor || options.control == Control::path)) {
      sources_.bring_up_to_date();
      const bool none = options.control == Control::path && body_.admissible().is_empty();
      if (none || goal != Goal::load_factor) {
        end_step();
        return none ? StopReason::no_admissible_load : StopReason::no_further_event;
      }
    }
    const bool upwards = target >= state_.load_factor;
    if (!next || (upwards ? next->load_factor > target : next->load_factor < target)) break;
    if (state_.events - events_before >= options.max_events) {
      fail(Failure::convergence, options.max_events,
           " events happened in this step, as many as the option stepping.max_events allows; raise it to go on");
    }
    sources_.mark();
    const bool increments = options.mode == SteppingMode::increments;
    if (!perform(*next, increments && state_.events > events_before)) {
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

// False if no equilibrium is left after the event, and what was reached before it is to be kept: then it did not
// happen.
bool CrackEvolution::perform(const Event& event, bool keep_what_was_reached) {
  if (!keep_what_was_reached) {
    book(event, sources_.perform());
    return true;
  }
  BodyState before = state_;
  const Start start{state_, state_.history.size(), state_.reactions.size()};
  try {
    book(event, sources_.perform());
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

void CrackEvolution::forget_lines(const Start& start) noexcept {
  static_cast<Sums&>(state_) = start.sums;
  state_.history.resize(start.history_size);
  state_.reactions.resize(start.reactions_size);
}

void CrackEvolution::return_to(const Start& start) noexcept {
  forget_lines(start);
  sources_.return_to_mark();
}

void CrackEvolution::book(const Event& event, const Outcome& outcome) {
  state_.work += outcome.work_before;
  state_.work = in_range(state_.work + outcome.work);
  state_.released_energy = in_range(state_.released_energy + outcome.released_energy);
  state_.bond_energy = in_range(state_.bond_energy + outcome.bond_energy);
  ++state_.events;
  state_.broken_bonds += outcome.broken;
  state_.fragments += outcome.fragments;
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

void CrackEvolution::end_step() {
  sources_.bring_up_to_date();
  HistoryEntry line;
  line.stored_energy = body_.stored_energy();
  line.critical_load_factor = state_.load_factor;
  line.critical_stored_energy = in_range(line.stored_energy + within(state_.load_factor));
  line.residual = body_.residual();
  write_line(line, energy_scale_of_supports(system_, state_.load_factor), body_.reactions());
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

void CrackEvolution::restore(EvolutionState state) noexcept {
  state_ = std::move(state);
  sources_.abandon();
}

void CrackEvolution::synchronize() {
  sources_.refresh();
  sources_.bring_up_to_date();
  sources_.forget();
  system_.forget_factor();
}

}  // namespace bempd::fracture

#include "fracture/crack_evolution.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

using coupling::Affine;
using coupling::evaluate;

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               std::vector<std::vector<int>> reaction_dofs)
    : system_(system),
      freed_parts_(system, positions),
      ratios_(system.bonds(), std::move(critical_stretch)),
      reaction_dofs_(std::move(reaction_dofs)),
      lookahead_(system, freed_parts_, ratios_, positions, reaction_dofs_) {
  const Eigen::Index dofs = 2 * system.node_count();
  force_ = prescribed_ = state_.displacement = Affine::Zero(dofs, 2);
  state_.total_displacement = state_.total_force = Eigen::VectorXd::Zero(dofs);
  state_.unloaded.assign(system.node_count(), 0);
  system_.place_nodes(positions);
  system_.mark_broken(cut);
  system_.commit_break(cut, {});
  state_.intact = system_.intact();
  state_.springs = system_.springs();
  lookahead_.expect_cracks(cut);
}

void CrackEvolution::set_load(const Affine& force, const Affine& prescribed) {
  close_window();
  force_ = force;
  prescribed_ = prescribed;
  state_.in_equilibrium = false;
  state_.first_unit_energy = -1;
  apply_load();
}

void CrackEvolution::apply_load() {
  Affine force = force_;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (state_.unloaded[node]) force.middleRows<2>(2 * node).setZero();
  }
  system_.set_load(std::move(force), prescribed_);
}

void CrackEvolution::drop_loads(const std::vector<int>& nodes) {
  for (int node : nodes) state_.unloaded[node] = 1;
  apply_load();
}

void CrackEvolution::find_equilibrium() {
  if (state_.in_equilibrium) return;
  EvolutionState start = without_history();
  try {
    hold_free_parts();
    state_.displacement = system_.solve();
    {
      const Stopwatch watch(seconds_search_);
      ratios_.update(state_.displacement);
    }
    state_.work += absorb(state_.load_factor);
    if (state_.first_unit_energy < 0) state_.first_unit_energy = unit_energy();
    state_.in_equilibrium = true;
  } catch (...) {
    start.history = std::move(state_.history);
    start.reactions = std::move(state_.reactions);
    restore(std::move(start));
    throw;
  }
}

void CrackEvolution::hold_free_parts() {
  const FreedParts freed = freed_parts_.all_pieces(state_.total_displacement);
  system_.commit_break({}, freed.springs);
  if (!freed.nodes_with_lost_loads.empty()) drop_loads(freed.nodes_with_lost_loads);
  state_.fragments += freed.fragments;
  state_.springs = system_.springs();
}

double CrackEvolution::absorb(double load_factor) {
  const Eigen::VectorXd displacement = evaluate(state_.displacement, load_factor);
  const Eigen::VectorXd force = system_.internal_force(displacement);
  // On the straight way between two states the trapezoid rule is exact. In equilibrium internal forces equal the loads.
  const double work = 0.5 * (state_.total_force + force).dot(displacement - state_.total_displacement);
  state_.total_displacement = displacement;
  state_.total_force = force;
  state_.largest_force = std::max(state_.largest_force, force.cwiseAbs().maxCoeff());
  state_.load_factor = load_factor;
  return work;
}

void CrackEvolution::move_to(double load_factor) {
  if (load_factor != state_.load_factor) state_.work += absorb(load_factor);
}

double CrackEvolution::stored_energy() const { return 0.5 * state_.total_displacement.dot(state_.total_force); }

bool CrackEvolution::energies_are_lost() const {
  const double displacement = state_.total_displacement.lpNorm<Eigen::Infinity>();
  const double force = state_.total_force.lpNorm<Eigen::Infinity>();
  return displacement > 0 && force > 0 && !std::isnormal(displacement * force);
}

double CrackEvolution::unit_energy() const {
  const Eigen::VectorXd unit = state_.displacement.col(1);
  return 0.5 * unit.dot(system_.internal_force(unit));
}

double CrackEvolution::residual() const {
  double unbalanced = 0;
  const Eigen::VectorXd load = evaluate(system_.force(), state_.load_factor);
  for (Eigen::Index dof = 0; dof < load.size(); ++dof) {
    if (system_.is_prescribed(static_cast<int>(dof))) continue;
    unbalanced = std::max(unbalanced, std::abs(state_.total_force[dof] - load[dof]));
  }
  return state_.largest_force > 0 ? unbalanced / state_.largest_force : unbalanced;
}

void CrackEvolution::record(std::int64_t event, double stretch_ratio) {
  append_history(event, stretch_ratio, stored_energy(), residual());
  for (std::size_t s = 0; s < reaction_dofs_.size(); ++s) {
    const Eigen::Vector2d force = present_reaction(s);
    state_.reactions.push_back(force.x());
    state_.reactions.push_back(force.y());
  }
}

void CrackEvolution::append_history(std::int64_t event, double stretch_ratio, double stored, double residual) {
  state_.largest_work = std::max(state_.largest_work, std::abs(state_.work));
  const double difference = std::abs(state_.work - stored - state_.released_energy);
  const double error = state_.largest_work > 0 ? difference / state_.largest_work : difference;
  state_.worst_energy_balance_error = std::max(state_.worst_energy_balance_error, error);
  state_.residual = residual;
  state_.history.push_back({event, state_.broken_bonds, state_.load_factor, stretch_ratio, stored,
                            state_.released_energy, state_.work, error, state_.residual});
}

Eigen::Vector2d CrackEvolution::present_reaction(std::size_t support) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int dof : reaction_dofs_[support]) {
    const double load = system_.force()(dof, 0) + state_.load_factor * system_.force()(dof, 1);
    sum[dof % 2] += state_.total_force[dof] - load;
  }
  return sum;
}

void CrackEvolution::note_separation() {
  if (unit_energy() < separated_energy_ratio * state_.first_unit_energy) state_.separated = true;
}

EvolutionState CrackEvolution::without_history() {
  // The history only grows; copying it at every step would cost more and more.
  std::vector<HistoryEntry> history;
  std::vector<double> reactions;
  history.swap(state_.history);
  reactions.swap(state_.reactions);
  EvolutionState copy = state_;
  history.swap(state_.history);
  reactions.swap(state_.reactions);
  return copy;
}

StopReason CrackEvolution::advance(double target, Goal goal, const SteppingOptions& options,
                                   const std::function<void(const EvolutionState&)>& on_event) {
  std::optional<Start> start;
  const std::int64_t events_before = state_.events;
  try {
    if (!state_.in_equilibrium) {
      mark_start(start);
      find_equilibrium();
    }
    for (;;) {
      if (goal == Goal::separation && state_.separated) return StopReason::separated;
      const ForeseenEvent* foreseen = foreseen_event(target, options, start);
      const std::optional<double> next = foreseen ? foreseen->load_factor : next_event(target, options);
      const bool beyond = next && (target >= state_.load_factor ? *next > target : *next < target);
      if (!next && goal != Goal::load_factor) {
        record(0, 0);
        return StopReason::no_further_event;
      }
      if (!next || beyond) break;
      if (state_.events - events_before >= options.max_events) {
        fail(Failure::convergence, options.max_events,
             " events happened in this step, as many as the option stepping.max_events allows; raise it to go on");
      }
      mark_start(start);
      if (foreseen) {
        perform_foreseen(*foreseen);
      } else {
        perform_event(*next, options);
      }
      if (on_event) on_event(state_);
      if (goal == Goal::next_event) return state_.separated ? StopReason::separated : StopReason::event;
    }
    catch_up();
    move_to(target);
    record(0, 0);
    return state_.separated ? StopReason::separated : StopReason::load_factor;
  } catch (...) {
    if (start) return_to(std::move(*start));
    throw;
  }
}

void CrackEvolution::restore(EvolutionState state) {
  lookahead_.forget();
  fields_are_behind_ = false;
  whole_body_events_ = 0;
  patience_ = 1;
  state_ = std::move(state);
  system_.restore(state_.intact, state_.springs);
  apply_load();
  ratios_.update(state_.displacement);
}

}  // namespace bempd::fracture

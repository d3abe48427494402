#include "fracture/loaded_body.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/balance.hpp"
#include "fracture/free_motions.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Residual from which on a motion may have lost its resistance.
constexpr double suspicious_residual = 1e-8;
// Rounding of a solution whose forces nearly cancel, relative to these forces.
constexpr double rounding_of_parts = 1e-12;

std::vector<int> nodes_with_force(const coupling::Affine& force) {
  std::vector<int> nodes;
  for (Eigen::Index node = 0; node < force.rows() / 2; ++node)
    if (!force.middleRows<2>(2 * node).isZero(0)) nodes.push_back(static_cast<int>(node));
  return nodes;
}

}  // namespace

using coupling::Affine;
using coupling::evaluate;

LoadedBody::LoadedBody(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                       std::vector<double> critical_stretch, const std::vector<int>& cut,
                       std::vector<std::vector<int>> reaction_dofs, ContactPlan contact, BodyState& state)
    : system_(system),
      positions_(positions),
      freed_parts_(system, positions),
      ratios_(system.terms(), std::move(critical_stretch)),
      faces_(system, positions, std::move(contact), cut),
      reaction_dofs_(std::move(reaction_dofs)),
      state_(state) {
  const Eigen::Index dofs = 2 * system.node_count();
  force_ = prescribed_ = state_.displacement = Affine::Zero(dofs, 2);
  state_.total_displacement = state_.total_force = Eigen::VectorXd::Zero(dofs);
  state_.unloaded.assign(system.node_count(), 0);
  system_.place_nodes(positions);
  system_.mark_broken(cut);
  system_.commit_break(cut, {});
  state_.stages = system_.stages();
  state_.springs = system_.springs();
  state_.faces.closed = system_.constraints().closed();
  ratios_.enter(state_.stages);
  if (!system_.has_offsets()) return;
  system_.condense();
  state_.total_force = system_.internal_force(state_.total_displacement, state_.load_factor);
}

double LoadedBody::energy_at_rest() const {
  return system_.has_offsets() ? system_.energy(Eigen::VectorXd::Zero(2 * system_.node_count()), 0) : 0;
}

void LoadedBody::set_load(const Affine& force, const Affine& prescribed, const CrackPressures& pressures) {
  Affine own_force = force, own_prescribed = prescribed, held = prescribed, carried = this->carried(force, pressures);
  CrackPressures own_pressures = pressures;
  std::vector<int> loaded = nodes_with_force(has_fluid() ? carried : force);
  // No memory is allocated from here on, so either all changes happen or none.
  force_ = std::move(own_force);
  prescribed_ = std::move(own_prescribed);
  pressures_.swap(own_pressures);
  loaded_nodes_ = std::move(loaded);
  state_.in_equilibrium = false;
  state_.first_unit_energy = -1;
  system_.set_load(std::move(carried), std::move(held));
}

void LoadedBody::take_over(const Affine& force, const Affine& prescribed, const CrackPressures& pressures) {
  const bool was_in_equilibrium = state_.in_equilibrium;
  set_load(force, prescribed, pressures);
  const bool constant = system_.force().col(1).isZero(0) && prescribed_.col(1).isZero(0) && !system_.has_offsets();
  if (!was_in_equilibrium || !constant) return;
  state_.displacement.col(0) = state_.total_displacement;
  state_.displacement.col(1).setZero();
  update_ratios();
  state_.first_unit_energy = 0;
  state_.in_equilibrium = true;
}

ActingLoads LoadedBody::acting_loads() const {
  return {force_, prescribed_, pressures_, loaded_nodes_, state_.in_equilibrium, state_.first_unit_energy};
}

void LoadedBody::restore_loads(ActingLoads loads) noexcept {
  force_.swap(loads.force);
  loaded_nodes_.swap(loads.loaded_nodes);
  prescribed_.swap(loads.prescribed);
  pressures_.swap(loads.pressures);
  state_.in_equilibrium = loads.in_equilibrium;
  state_.first_unit_energy = loads.first_unit_energy;
}

Affine LoadedBody::without_lost_loads(Affine force) const {
  for (int node = 0; node < system_.node_count(); ++node) {
    if (state_.unloaded[node]) force.middleRows<2>(2 * node).setZero();
  }
  return force;
}

Affine LoadedBody::carried(Affine force, const CrackPressures& pressures) const {
  force = without_lost_loads(std::move(force));
  if (has_fluid()) fluid_.add_forces(pressures, system_.terms(), system_.intact(), state_.unloaded, force);
  return force;
}

void LoadedBody::apply_load() {
  Affine force = carried(force_, pressures_);
  if (has_fluid()) loaded_nodes_ = nodes_with_force(force);
  system_.set_load(std::move(force), prescribed_);
}

Eigen::RowVector2d LoadedBody::pressure_in(int crack) const {
  const auto found = pressures_.find(crack);
  return found == pressures_.end() ? Eigen::RowVector2d::Zero() : found->second;
}

Eigen::VectorXd LoadedBody::let_flow() {
  const Eigen::VectorXd before = evaluate(system_.force(), state_.load_factor);
  apply_load();
  return evaluate(system_.force(), state_.load_factor) - before;
}

void LoadedBody::drop_loads(const std::vector<int>& nodes) {
  for (int node : nodes) state_.unloaded[node] = 1;
  apply_load();
}

LoadedBody::FirstEquilibrium LoadedBody::find_equilibrium() {
  const Eigen::VectorXd before = state_.total_displacement;
  const double stored_before = stored_energy(), unbalanced_before = unbalanced_share();
  update_faces();
  FreedParts freed = freed_parts_.all_pieces(before);
  system_.commit({}, freed.springs);
  if (!freed.nodes_with_lost_loads.empty()) drop_loads(freed.nodes_with_lost_loads);
  FirstEquilibrium result{0, freed.fragments, {}, 0, {}};
  for (const coupling::HoldingSpring& spring : freed.springs) result.held.push_back(spring.node);
  const bool cracked = std::find(system_.intact().begin(), system_.intact().end(), 0) != system_.intact().end();
  if (cracked) {
    if (!system_.has_current_factor()) system_.forget_factor();  // that of another matrix knows nothing of hinges
    const HeldMotions held = solve_and_hold(*this, {}, before, [&] { return !is_balanced(); });
    result.fragments += held.fragments;
    result.held.insert(result.held.end(), held.nodes.begin(), held.nodes.end());
  } else {
    solve();  // what moves freely without cracks is the host's mistake
  }
  const bool had_contact = system_.constraints().closed_count() > 0;
  const Settled settled = settle_constraints(0);
  result.switches = settled.switched;
  result.fragments += settled.fragments;
  result.held.insert(result.held.end(), settled.held.begin(), settled.held.end());
  if (result.fragments > 0) result.lost_balance = {unbalanced_before, unbalanced_share()};
  state_.springs = system_.springs();
  keep_held_parts_dry();
  update_ratios();
  result.work = absorb(state_.load_factor);
  // The trapezoidal rule for the work is invalid if faces close or open on the way from the previous loads; the work is
  // then the change of the stored energy.
  if (had_contact || result.switches > 0) result.work = stored_energy() - stored_before;
  if (state_.first_unit_energy < 0) state_.first_unit_energy = unit_energy();
  state_.in_equilibrium = true;
  return result;
}

bool LoadedBody::is_balanced() const {
  const double f = state_.load_factor;
  const Eigen::VectorXd force = system_.internal_force(evaluate(state_.displacement, f), f);
  const double largest =
      std::max({state_.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, f)});
  const double residual = fracture::residual(system_, force, f, largest);
  if (residual <= suspicious_residual) return true;
  // Parts of the loads that nearly cancel (as in a short path at a late time) leave rounding errors of both.
  const double parts = system_.internal_force(state_.displacement.col(0)).lpNorm<Eigen::Infinity>() +
                       std::abs(f) * system_.internal_force(state_.displacement.col(1)).lpNorm<Eigen::Infinity>();
  return residual * largest <= rounding_of_parts * parts;
}

void LoadedBody::solve() { state_.displacement = system_.solve(); }

void LoadedBody::update_ratios() {
  const Stopwatch watch(seconds_search_);
  ratios_.enter(system_.stages());
  ratios_.update(state_.displacement);
}

void LoadedBody::restore() {
  system_.restore(state_.stages, state_.springs);
  faces_.restore(state_.faces);
  apply_load();
  ratios_.enter(state_.stages);
  ratios_.update(state_.displacement);
}

double LoadedBody::absorb(double load_factor) {
  const Eigen::VectorXd displacement = evaluate(state_.displacement, load_factor);
  const Eigen::VectorXd force = system_.internal_force(displacement, load_factor);
  if (!displacement.allFinite() || !force.allFinite()) fail_out_of_range();
  // The trapezoidal rule is exact on the straight path between two states; in equilibrium the internal forces equal the
  // loads.
  double work = 0.5 * (state_.total_force + force).dot(displacement - state_.total_displacement);
  if (system_.has_offsets() && load_factor != state_.load_factor) {
    const double before = system_.energy_slope(state_.total_displacement, state_.load_factor);
    const double after = system_.energy_slope(displacement, load_factor);
    work += 0.5 * (before + after) * (load_factor - state_.load_factor);
  }
  state_.total_displacement = displacement;
  state_.total_force = force;
  state_.largest_force =
      std::max({state_.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, load_factor)});
  state_.load_factor = load_factor;
  return work;
}

double LoadedBody::move_to(double load_factor) { return load_factor != state_.load_factor ? absorb(load_factor) : 0; }

void LoadedBody::show(Affine displacement) {
  state_.displacement = std::move(displacement);
  update_ratios();
  state_.total_displacement = evaluate(state_.displacement, state_.load_factor);
  state_.total_force = system_.internal_force(state_.total_displacement, state_.load_factor);
}

std::optional<double> LoadedBody::next_critical(const LoadWay& way) {
  const Stopwatch watch(seconds_search_);
  return fracture::next_critical(bonds(), way);
}

double LoadedBody::stored_energy() const {
  if (system_.has_offsets()) return system_.energy(state_.total_displacement, state_.load_factor);
  return 0.5 * state_.total_displacement.dot(state_.total_force);  // Clapeyron's theorem
}

double LoadedBody::potential_of_loads() const {
  return evaluate(system_.force(), state_.load_factor).dot(state_.total_displacement);
}

double LoadedBody::stored_energy_at(double load_factor) const {
  if (load_factor == state_.load_factor) return stored_energy();
  if (!system_.has_offsets() && state_.displacement.col(0).isZero(0)) return load_factor * load_factor * unit_energy();
  const Eigen::VectorXd displacement = evaluate(state_.displacement, load_factor);
  if (system_.has_offsets()) return system_.energy(displacement, load_factor);
  return 0.5 * displacement.dot(system_.internal_force(displacement, load_factor));
}

double LoadedBody::unit_energy() const { return system_.unit_energy(state_.displacement.col(1)); }

double LoadedBody::residual() const {
  return fracture::residual(system_, state_.total_force, state_.load_factor, state_.largest_force);
}

}  // namespace bempd::fracture

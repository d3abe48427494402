#include "fracture/body_loads.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "number_range.hpp"

namespace bempd::fracture {

namespace {

std::vector<int> nodes_with_force(const coupling::Affine& force) {
  std::vector<int> nodes;
  for (Eigen::Index node = 0; node < force.rows() / 2; ++node)
    if (!force.middleRows<2>(2 * node).isZero(0)) nodes.push_back(static_cast<int>(node));
  return nodes;
}

}  // namespace

using coupling::Affine;
using coupling::evaluate;

BodyLoads::BodyLoads(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, BodyState& state)
    : system_(system), positions_(positions), state_(state) {
  force_ = prescribed_ = Affine::Zero(2 * system.node_count(), 2);
}

void BodyLoads::set(const Affine& force, const Affine& prescribed, const CrackPressures& pressures) {
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

ActingLoads BodyLoads::acting() const {
  return {force_, prescribed_, pressures_, loaded_nodes_, state_.in_equilibrium, state_.first_unit_energy};
}

void BodyLoads::restore(ActingLoads loads) noexcept {
  force_.swap(loads.force);
  loaded_nodes_.swap(loads.loaded_nodes);
  prescribed_.swap(loads.prescribed);
  pressures_.swap(loads.pressures);
  state_.in_equilibrium = loads.in_equilibrium;
  state_.first_unit_energy = loads.first_unit_energy;
}

Affine BodyLoads::without_lost_loads(Affine force) const {
  for (int node = 0; node < system_.node_count(); ++node) {
    if (state_.unloaded[node]) force.middleRows<2>(2 * node).setZero();
  }
  return force;
}

Affine BodyLoads::carried(Affine force, const CrackPressures& pressures) const {
  force = without_lost_loads(std::move(force));
  if (has_fluid()) fluid_.add_forces(pressures, system_.terms(), system_.stages().intact(), state_.unloaded, force);
  return force;
}

void BodyLoads::apply() {
  Affine force = carried(force_, pressures_);
  if (has_fluid()) loaded_nodes_ = nodes_with_force(force);
  system_.set_load(std::move(force), prescribed_);
}

Eigen::RowVector2d BodyLoads::pressure_in(int crack) const {
  const auto found = pressures_.find(crack);
  return found == pressures_.end() ? Eigen::RowVector2d::Zero() : found->second;
}

Eigen::VectorXd BodyLoads::spread_fluid() {
  const Eigen::VectorXd before = evaluate(system_.load().force(), state_.load_factor);
  apply();
  return evaluate(system_.load().force(), state_.load_factor) - before;
}

void BodyLoads::drop(const std::vector<int>& nodes) {
  for (int node : nodes) state_.unloaded[node] = 1;
  apply();
}

Point BodyLoads::on(int node, double load_factor) const {
  return system_.load().force().middleRows<2>(2 * static_cast<Eigen::Index>(node)) * Eigen::Vector2d(1, load_factor);
}

double BodyLoads::unbalanced_share() const {
  // Loads are scaled by a power of 2 of their size, because the squares of extreme loads exceed the range of numbers.
  double largest = 0;
  for (int node : loaded_nodes_) largest = std::max(largest, on(node, state_.load_factor).lpNorm<Eigen::Infinity>());
  const double unit = std::ldexp(1.0, -far_exponent(largest));
  double size = 0;
  Point sum = Point::Zero(), centre = Point::Zero();
  for (int node : loaded_nodes_) {
    const Point load = unit * on(node, state_.load_factor);
    sum += load;
    size += load.norm();
    centre += load.norm() * positions_[static_cast<std::size_t>(node)];
  }
  if (!(size > 0)) return 0;
  centre /= size;
  double moment = 0, inertia = 0;
  for (int node : loaded_nodes_) {
    const Point load = unit * on(node, state_.load_factor), arm = positions_[static_cast<std::size_t>(node)] - centre;
    moment += cross(arm, load);
    inertia += load.norm() * arm.squaredNorm();
  }
  const double radius = std::sqrt(inertia / size);
  return std::max(sum.norm(), radius > 0 ? std::abs(moment) / radius : 0) / (0.5 * size);
}

}  // namespace bempd::fracture

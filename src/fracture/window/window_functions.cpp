#include "fracture/window/window_functions.hpp"

namespace bempd::fracture {

namespace {

// Indices in the list of functions at which the functions of loads, of supports, and of reactions begin. Loads and
// supports have two functions each, for the constant and the proportional part of the load.
constexpr Eigen::Index loads = 0, supports = 2, first_reaction = 4;

// Function of the window's displacements: the work of the body's internal forces on the support displacements `moved`.
// Nodes tied to a support move with it.
WindowSolver::Function force_of_supports(const coupling::EquilibriumSystem& system, Eigen::VectorXd moved) {
  system.ties().expand(moved);
  Eigen::VectorXd weights = system.response().internal_force(moved);
  return {std::move(weights), std::move(moved)};
}

}  // namespace

std::vector<WindowSolver::Function> WindowFunctions::list() const {
  std::vector<WindowSolver::Function> result;
  const Eigen::Index dofs = 2 * system_.node_count();
  for (int part = 0; part < 2; ++part) {
    Eigen::VectorXd load = system_.load().force().col(part);
    for (Eigen::Index dof = 0; dof < dofs; ++dof) {
      if (system_.unknowns().is_prescribed(static_cast<int>(dof))) load[dof] = 0;
    }
    result.push_back({load, {}});
  }
  for (int part = 0; part < 2; ++part) {
    result.push_back(force_of_supports(system_, system_.load().prescribed().col(part)));
  }
  for (std::size_t s = 0; s < supports_.own.size(); ++s) {
    for (int component = 0; component < 2; ++component) {
      Eigen::VectorXd moved = Eigen::VectorXd::Zero(dofs);
      for (int dof : supports_.own[s])
        if (dof % 2 == component) moved[dof] = 1;
      for (const coupling::SharedForce& one : supports_.shared[s])
        if (one.dof % 2 == component) moved[one.dof] += one.weight;
      result.push_back(force_of_supports(system_, std::move(moved)));
    }
  }
  return result;
}

EnergyForm WindowFunctions::energy(const Values& values) {
  return {values(loads, 0) + values(supports, 0), values(loads, 1) + values(supports + 1, 0),
          values(loads + 1, 1) + values(supports + 1, 1)};
}

double WindowFunctions::work(const Values& before, const Values& after, double load_factor) {
  const Eigen::Vector2d at(1, load_factor);
  return at.dot((after - before).middleRows<2>(loads) * at);
}

std::vector<double> WindowFunctions::reactions(const Values& values, double load_factor) const {
  const Eigen::Vector2d at(1, load_factor);
  std::vector<double> result;
  for (std::size_t s = 0; s < supports_.own.size(); ++s) {
    Eigen::Vector2d reaction = values.middleRows<2>(first_reaction + 2 * static_cast<Eigen::Index>(s)) * at;
    const auto load = [&](int dof) { return system_.load().force().row(dof).dot(at); };
    for (int dof : supports_.own[s]) reaction[dof % 2] -= load(dof);
    for (const coupling::SharedForce& one : supports_.shared[s]) reaction[one.dof % 2] -= one.weight * load(one.dof);
    result.insert(result.end(), {reaction.x(), reaction.y()});
  }
  return result;
}

}  // namespace bempd::fracture

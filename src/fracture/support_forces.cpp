#include "fracture/support_forces.hpp"

#include <cmath>
#include <limits>

#include "number_range.hpp"

namespace bempd::fracture {

Eigen::Vector2d SupportForces::reaction(std::size_t support) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int dof : dofs_.own[support]) sum[dof % 2] += reaction_at(dof);
  for (const coupling::SharedForce& one : dofs_.shared[support]) sum[one.dof % 2] += one.weight * reaction_at(one.dof);
  return sum;
}

double SupportForces::reaction_at(int dof) const {
  const double load = system_.load().force()(dof, 0) + state_.load_factor * system_.load().force()(dof, 1);
  return state_.total_force[dof] - load;
}

double SupportForces::reaction_moment(std::size_t support, const Point& about) const {
  const auto arm = [&](int node, int component) {
    const Point from = positions_[static_cast<std::size_t>(node)] - about;
    return component == 0 ? -from.y() : from.x();
  };
  double sum = 0;
  for (int dof : dofs_.own[support]) sum += reaction_at(dof) * arm(dof / 2, dof % 2);
  for (const coupling::SharedForce& one : dofs_.shared[support])
    sum += one.weight * reaction_at(one.dof) * arm(one.node, one.dof % 2);
  return sum;
}

std::vector<double> SupportForces::reactions() const {
  std::vector<double> result;
  for (std::size_t s = 0; s < dofs_.own.size(); ++s) {
    const Eigen::Vector2d force = reaction(s);
    result.insert(result.end(), {force.x(), force.y()});
  }
  return result;
}

std::vector<double> SupportForces::displacements() const {
  std::vector<double> result;
  for (const std::vector<int>& dofs : dofs_.own) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), count = Eigen::Vector2d::Zero();
    for (int dof : dofs) {
      if (!system_.unknowns().is_prescribed(dof)) continue;
      sum[dof % 2] += system_.load().prescribed()(dof, 0) + state_.load_factor * system_.load().prescribed()(dof, 1);
      count[dof % 2] += 1;
    }
    for (int component : {0, 1})
      result.push_back(count[component] > 0 ? sum[component] / count[component]
                                            : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

double SupportForces::resistance(const std::vector<double>& reactions, double load_factor) const {
  double half = 0;
  for (std::size_t i = 0; i < reactions.size(); i += 2) half += 0.5 * std::hypot(reactions[i], reactions[i + 1]);
  for (int node : loads_.loaded_nodes()) {
    const Point load = loads_.on(node, load_factor);
    half += 0.5 * std::hypot(load.x(), load.y());  // hypot: squares of loads may exceed the range of numbers
  }
  return in_range(half);
}

}  // namespace bempd::fracture

// What supports exert on a body, and what it bears.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

Eigen::Vector2d LoadedBody::reaction(std::size_t support) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int dof : reaction_dofs_[support]) sum[dof % 2] += reaction_at(dof);
  return sum;
}

double LoadedBody::reaction_at(int dof) const {
  const double load = system_.force()(dof, 0) + state_.load_factor * system_.force()(dof, 1);
  return state_.total_force[dof] - load;
}

double LoadedBody::reaction_moment(std::size_t support, const Point& about) const {
  double sum = 0;
  for (int dof : reaction_dofs_[support]) {
    const Point arm = positions_[static_cast<std::size_t>(dof / 2)] - about;
    sum += reaction_at(dof) * (dof % 2 == 0 ? -arm.y() : arm.x());
  }
  return sum;
}

std::vector<double> LoadedBody::reactions() const {
  std::vector<double> result;
  for (std::size_t s = 0; s < reaction_dofs_.size(); ++s) {
    const Eigen::Vector2d force = reaction(s);
    result.insert(result.end(), {force.x(), force.y()});
  }
  return result;
}

std::vector<double> LoadedBody::support_displacements() const {
  std::vector<double> result;
  for (const std::vector<int>& dofs : reaction_dofs_) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), count = Eigen::Vector2d::Zero();
    for (int dof : dofs) {
      if (!system_.is_prescribed(dof)) continue;
      sum[dof % 2] += system_.prescribed()(dof, 0) + state_.load_factor * system_.prescribed()(dof, 1);
      count[dof % 2] += 1;
    }
    for (int component : {0, 1})
      result.push_back(count[component] > 0 ? sum[component] / count[component]
                                            : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

double LoadedBody::resistance(const std::vector<double>& reactions, double load_factor) const {
  double sum = 0;
  for (std::size_t i = 0; i < reactions.size(); i += 2) sum += std::hypot(reactions[i], reactions[i + 1]);
  const Eigen::Vector2d at(1, load_factor);
  for (int node : loaded_nodes_) sum += (system_.force().middleRows<2>(2 * node) * at).norm();
  return 0.5 * sum;
}

double LoadedBody::unbalanced_share() const {
  const Eigen::Vector2d at(1, state_.load_factor);
  const auto load_on = [&](int node) -> Point { return system_.force().middleRows<2>(2 * node) * at; };
  double size = 0;
  Point sum = Point::Zero(), centre = Point::Zero();
  for (int node : loaded_nodes_) {
    const Point load = load_on(node);
    sum += load;
    size += load.norm();
    centre += load.norm() * positions_[static_cast<std::size_t>(node)];
  }
  if (!(size > 0)) return 0;
  centre /= size;
  double moment = 0, inertia = 0;
  for (int node : loaded_nodes_) {
    const Point load = load_on(node), arm = positions_[static_cast<std::size_t>(node)] - centre;
    moment += cross(arm, load);
    inertia += load.norm() * arm.squaredNorm();
  }
  const double radius = std::sqrt(inertia / size);
  return std::max(sum.norm(), radius > 0 ? std::abs(moment) / radius : 0) / (0.5 * size);
}

}  // namespace bempd::fracture

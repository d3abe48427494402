// Reactions of supports, and the force that the body carries.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/loaded_body.hpp"
#include "number_range.hpp"

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

Point LoadedBody::load_on(int node, double load_factor) const {
  return system_.force().middleRows<2>(2 * static_cast<Eigen::Index>(node)) * Eigen::Vector2d(1, load_factor);
}

double LoadedBody::resistance(const std::vector<double>& reactions, double load_factor) const {
  double half = 0;
  for (std::size_t i = 0; i < reactions.size(); i += 2) half += 0.5 * std::hypot(reactions[i], reactions[i + 1]);
  for (int node : loaded_nodes_) {
    const Point load = load_on(node, load_factor);
    half += 0.5 * std::hypot(load.x(), load.y());  // no square of it has to be within the range of numbers
  }
  return in_range(half);
}

double LoadedBody::unbalanced_share() const {
  // Loads are scaled by a power of 2 of their size, because the squares of extreme loads exceed the range of numbers.
  double largest = 0;
  for (int node : loaded_nodes_)
    largest = std::max(largest, load_on(node, state_.load_factor).lpNorm<Eigen::Infinity>());
  const double unit = std::ldexp(1.0, -far_exponent(largest));
  double size = 0;
  Point sum = Point::Zero(), centre = Point::Zero();
  for (int node : loaded_nodes_) {
    const Point load = unit * load_on(node, state_.load_factor);
    sum += load;
    size += load.norm();
    centre += load.norm() * positions_[static_cast<std::size_t>(node)];
  }
  if (!(size > 0)) return 0;
  centre /= size;
  double moment = 0, inertia = 0;
  for (int node : loaded_nodes_) {
    const Point load = unit * load_on(node, state_.load_factor),
                arm = positions_[static_cast<std::size_t>(node)] - centre;
    moment += cross(arm, load);
    inertia += load.norm() * arm.squaredNorm();
  }
  const double radius = std::sqrt(inertia / size);
  return std::max(sum.norm(), radius > 0 ? std::abs(moment) / radius : 0) / (0.5 * size);
}

}  // namespace bempd::fracture

#include "fracture/contact/held_parts.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/rigid_motion.hpp"
#include "fracture/part_holder.hpp"

namespace bempd::fracture {

namespace {

// Least change of a gap in a motion that is not rounding, as a share of the largest change that the gap's weights allow
// for a motion of that size.
constexpr double least_gap_change = 1e-6;

// Ratio of a node's displacement to the largest displacement in a held motion, below which the node counts as not
// moving.
constexpr double least_share_moved = 1e-6;

using Motions = std::vector<Eigen::VectorXd>;

// Adds the rigid motions of a dense body (boundary element region) that has no support.
void add_free_motions(const std::vector<int>& body, const std::vector<Point>& positions, Motions& motions) {
  const coupling::RigidMotion free(positions, body, {});
  for (int k = 0; k < free.free_count(); ++k) {
    Eigen::VectorXd& motion = motions.emplace_back(Eigen::VectorXd::Zero(2 * static_cast<int>(positions.size())));
    for (const int node : body) motion.segment<2>(2 * node) = free.displacement(k, positions[node]);
  }
}

// Completes a rigid motion of a dense body (boundary element region). The sparse system has eliminated some nodes of
// the body; their displacements follow from those of the other nodes.
void complete(const coupling::EquilibriumSystem& system, const std::vector<int>& body,
              const std::vector<Point>& positions, Eigen::VectorXd& motion) {
  std::vector<int> hidden, visible;
  for (const int node : body) (shows_motion(system, node) ? visible : hidden).push_back(node);
  const coupling::RigidFit fit = coupling::nearest_rigid_motion(positions, visible, motion);
  for (const int node : hidden) {
    const Point arm = positions[node] - fit.centre;
    motion.segment<2>(2 * node) = fit.translation + fit.rotation * Point(-arm.y(), arm.x());
  }
}

bool changes_gap(const Eigen::VectorXd& motion, const Eigen::VectorXd& weights) {
  return std::abs(weights.dot(motion)) > least_gap_change * weights.lpNorm<1>() * motion.lpNorm<Eigen::Infinity>();
}

}  // namespace

std::vector<char> HeldParts::all_nodes() const {
  std::vector<char> all = nodes;
  for (const Eigen::VectorXd& motion : motions) {
    const double limit = least_share_moved * motion.lpNorm<Eigen::Infinity>();
    for (std::size_t node = 0; node < all.size(); ++node)
      if (motion.segment<2>(2 * static_cast<Eigen::Index>(node)).norm() > limit) all[node] = 1;
  }
  return all;
}

std::vector<char> exact_constraints_that_push(const coupling::EquilibriumSystem& system,
                                              const std::vector<Point>& positions, const HeldParts& parts) {
  const std::size_t count = system.constraints().exact_count();
  std::vector<char> pushes(count, 0);
  if (count == 0) return pushes;
  Motions motions = parts.motions;
  for (const std::vector<int>& body : system.dense_bodies().list()) {
    for (std::size_t k = 0; k < parts.motions.size(); ++k) complete(system, body, positions, motions[k]);
    if (std::any_of(body.begin(), body.end(), [&](int node) { return parts.nodes[node] != 0; }))
      add_free_motions(body, positions, motions);
  }
  Eigen::VectorXd weights(2 * system.node_count());
  for (std::size_t i = 0; i < count && !motions.empty(); ++i) {
    weights.setZero();
    system.operators().add_gap_function(static_cast<Eigen::Index>(i), weights);
    const auto changes = [&](const Eigen::VectorXd& motion) { return changes_gap(motion, weights); };
    pushes[i] = std::any_of(motions.begin(), motions.end(), changes) ? 1 : 0;
  }
  return pushes;
}

}  // namespace bempd::fracture

#include "fracture/part_holder.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::fracture {

namespace {

using coupling::EquilibriumSystem;

// Largest number of springs that are added one after another to hold free motions; bodies with a hundred initial cracks
// have needed ten.
constexpr int most_holds = 64;

// Ratio of the stiffness against a motion to the stiffness in the stiffest direction, below which the motion is free up
// to rounding.
constexpr double free_motion_resistance = 1e-13;

// Largest elongation of a term (free_elongation) and largest bending of a dense body (free_bending) in a free motion,
// over the largest displacement of the motion. A motion with larger values is only soft. For example, the softest
// motion of a slender strip of length L and width h (in spacings), its bending, has about h / L^2 and 1.
constexpr double free_elongation = 1e-9, free_bending = 1e-6;

// Ratio of a node's displacement to the largest displacement in a free motion, below which the node counts as not
// moving.
constexpr double moved_share = 1e-6;

bool is_free(const EquilibriumSystem& system, const std::vector<Point>& positions, const coupling::SoftMotion& soft) {
  if (soft.resistance > free_motion_resistance) return false;
  for (std::size_t t = 0; t < system.terms().size(); ++t) {
    if (system.stages().stiffness()[t] == 0) continue;
    if (std::abs(system.terms().elongation(t, soft.motion.data())) > free_elongation) return false;
  }
  const std::vector<std::vector<int>>& bodies = system.dense_bodies().list();
  return std::all_of(bodies.begin(), bodies.end(), [&](const std::vector<int>& body) {
    std::vector<int> nodes;
    std::copy_if(body.begin(), body.end(), std::back_inserter(nodes),
                 [&](int node) { return shows_motion(system, node); });
    return coupling::nearest_rigid_motion(positions, nodes, soft.motion).deviation <= free_bending;
  });
}

// Nodes with loads that move in a motion.
std::vector<int> pushed_nodes(const EquilibriumSystem& system, const Eigen::VectorXd& motion) {
  std::vector<char> moves(system.node_count(), 0);
  const auto is_moved = [&](int node) { return motion.segment<2>(2 * node).norm() > moved_share; };
  for (int node = 0; node < system.node_count(); ++node) moves[node] = is_moved(node) ? 1 : 0;
  // Bodies that cannot break (boundary element regions) move as a whole.
  for (const std::vector<int>& body : system.dense_bodies().list()) {
    if (std::none_of(body.begin(), body.end(), is_moved)) continue;
    for (int node : body) moves[node] = 1;
  }
  std::vector<int> loaded;
  for (int node = 0; node < system.node_count(); ++node) {
    if (moves[node] && !system.load().force().middleRows<2>(2 * node).isZero(0)) loaded.push_back(node);
  }
  return loaded;
}

// Ratio of the force of a spring to the largest nodal force, below which the spring force is rounding.
constexpr double pushed_share = 1e-9;

}  // namespace

bool shows_motion(const EquilibriumSystem& system, int node) {
  const auto is_there = [&](int dof) {
    return system.unknowns().is_unknown(dof) || system.unknowns().is_prescribed(dof);
  };
  return is_there(2 * node) && is_there(2 * node + 1);
}

HeldMotions PartHolder::solve(std::span<const int> broken, const Eigen::VectorXd& before,
                              const std::function<bool()>& looks_free) {
  HeldMotions held;
  for (int hold = 0;; ++hold) {
    check_cancelled();
    bool free_motion = false;
    try {
      response_.solve();
      free_motion = looks_free();
    } catch (const Error& error) {
      if (error.failure() != Failure::unsolvable || hold == most_holds) throw;
      free_motion = true;
    }
    if (!free_motion && system_.motions().resists_all(broken)) return held;
    const coupling::SoftMotion soft = system_.motions().softest();
    if (!free_motion && !is_free(system_, positions_, soft)) return held;
    if (hold == most_holds) fail(Failure::unsolvable, "cracks leave parts that move freely, and holding them fails");
    const coupling::HoldingSpring spring = freed_parts_.spring_against(soft.motion, before);
    held.nodes.push_back(spring.node);
    system_.commit({}, {&spring, 1});
    system_.factor().forget();
    const std::vector<int> pushed = pushed_nodes(system_, soft.motion);
    if (pushed.empty()) continue;
    loads_.drop(pushed);
    held.loads_lost = true;
    ++held.fragments;
  }
}

HeldParts PartHolder::held_parts() const {
  FreedPartFinder::PartsOnSprings held = freed_parts_.held_parts();
  HeldParts parts{std::move(held.nodes), {}};
  // Closed faces do not count as connections here, so that the set of constraints barred from closing does not depend
  // on which faces are closed.
  if (!held.springs_in_supported_pieces.empty())
    parts.motions = system_.motions().motions_held_by(held.springs_in_supported_pieces);
  return parts;
}

void PartHolder::exclude_from_fluid() {
  if (!loads_.has_fluid() || system_.springs().empty()) return;
  const std::vector<char> held = held_parts().all_nodes();
  for (int node = 0; node < system_.node_count(); ++node)
    if (held[node] && system_.load().force().middleRows<2>(2 * node).isZero(0)) state_.unloaded[node] = 1;
}

bool PartHolder::unload_pushed() {
  if (!loads_.has_fluid() || system_.springs().empty()) return false;
  const double f = state_.load_factor;
  const Eigen::VectorXd u = coupling::evaluate(state_.displacement, f);
  double largest = 0;
  for (const coupling::HoldingSpring& s : system_.springs()) {
    const double moved = s.cosine * u[2 * s.node] + s.sine * u[2 * s.node + 1] - s.anchor;
    largest = std::max(largest, std::abs(s.stiffness * moved));
  }
  if (largest <= pushed_share * coupling::evaluate(system_.load().force(), f).lpNorm<Eigen::Infinity>()) return false;
  const std::vector<char> held = held_parts().all_nodes();
  std::vector<int> nodes;
  for (int node = 0; node < system_.node_count(); ++node)
    if (held[node]) nodes.push_back(node);
  loads_.drop(nodes);
  response_.solve();
  return true;
}

}  // namespace bempd::fracture

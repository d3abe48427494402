#include "fracture/free_motions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::fracture {

namespace {

using coupling::EquilibriumSystem;

// Largest number of springs that are added one after another; bodies with a hundred initial cracks have needed ten.
constexpr int most_holds = 64;

// Resistance relative to the stiffest direction below which a motion is free up to rounding.
constexpr double free_motion_resistance = 1e-13;

// Limits for a free motion: elongation of a term, and bending of a body, over the motion's largest displacement. With
// larger values the motion is only soft. For comparison, bending a slender strip of length L and width h (in spacings)
// has about h / L^2 and 1.
constexpr double free_elongation = 1e-9, free_bending = 1e-6;

// Displacement of a node over the largest one of a free motion below which the node counts as not moving.
constexpr double moved_share = 1e-6;

bool is_free(const EquilibriumSystem& system, const std::vector<Point>& positions, const coupling::SoftMotion& soft) {
  if (soft.resistance > free_motion_resistance) return false;
  for (std::size_t t = 0; t < system.terms().size(); ++t) {
    if (system.present_stiffness()[t] == 0) continue;
    if (std::abs(system.terms().elongation(t, soft.motion.data())) > free_elongation) return false;
  }
  return std::all_of(system.dense_bodies().begin(), system.dense_bodies().end(), [&](const std::vector<int>& body) {
    std::vector<int> nodes;
    std::copy_if(body.begin(), body.end(), std::back_inserter(nodes),
                 [&](int node) { return shows_motion(system, node); });
    return coupling::nearest_rigid_motion(positions, nodes, soft.motion).deviation <= free_bending;
  });
}

// Loaded nodes that a motion moves.
std::vector<int> pushed_nodes(const EquilibriumSystem& system, const Eigen::VectorXd& motion) {
  std::vector<char> moves(system.node_count(), 0);
  const auto is_moved = [&](int node) { return motion.segment<2>(2 * node).norm() > moved_share; };
  for (int node = 0; node < system.node_count(); ++node) moves[node] = is_moved(node) ? 1 : 0;
  // Bodies that cannot break (boundary element regions) move as a whole.
  for (const std::vector<int>& body : system.dense_bodies()) {
    if (std::none_of(body.begin(), body.end(), is_moved)) continue;
    for (int node : body) moves[node] = 1;
  }
  std::vector<int> loaded;
  for (int node = 0; node < system.node_count(); ++node) {
    if (moves[node] && !system.force().middleRows<2>(2 * node).isZero(0)) loaded.push_back(node);
  }
  return loaded;
}

}  // namespace

bool shows_motion(const EquilibriumSystem& system, int node) {
  const auto is_there = [&](int dof) { return system.is_unknown(dof) || system.is_prescribed(dof); };
  return is_there(2 * node) && is_there(2 * node + 1);
}

HeldMotions solve_and_hold(LoadedBody& body, std::span<const int> broken, const Eigen::VectorXd& before,
                           const std::function<bool()>& looks_free) {
  EquilibriumSystem& system = body.system();
  HeldMotions held;
  for (int hold = 0;; ++hold) {
    check_cancelled();
    bool free_motion = false;
    try {
      body.solve();
      free_motion = looks_free();
    } catch (const Error& error) {
      if (error.failure() != Failure::unsolvable || hold == most_holds) throw;
      free_motion = true;
    }
    if (!free_motion && system.resists_all_motions(broken)) return held;
    const coupling::SoftMotion soft = system.softest_motion();
    if (!free_motion && !is_free(system, body.positions(), soft)) return held;
    if (hold == most_holds) fail(Failure::unsolvable, "cracks leave parts that move freely, and holding them fails");
    const coupling::HoldingSpring spring = body.freed_parts().against(soft.motion, before);
    held.nodes.push_back(spring.node);
    system.commit({}, {&spring, 1});
    system.forget_factor();
    const std::vector<int> pushed = pushed_nodes(system, soft.motion);
    if (pushed.empty()) continue;
    body.drop_loads(pushed);
    held.loads_lost = true;
    ++held.fragments;
  }
}

}  // namespace bempd::fracture

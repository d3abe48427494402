#pragma once

#include <functional>
#include <vector>

#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Whether both displacements of a node are unknowns or prescribed: the node shows how a dense body moves, whose other
// nodes the sparse system has eliminated.
bool shows_motion(const coupling::EquilibriumSystem& system, int node);

// Parts that had to be held to make the equilibrium unique.
struct HeldMotions {
  std::vector<int> nodes;      // where a spring was put
  bool loads_lost = false;     // they pushed on something that moves freely
  std::int64_t fragments = 0;  // parts that lost them
};

// Solves the body's system, and holds free motions in the solution by springs at the displacement `before`.
// `looks_free` is asked after each solution whether some motion looks free; `broken` are the terms that broke last.
// Throws Error (unsolvable) if holding does not help.
HeldMotions solve_and_hold(LoadedBody& body, std::span<const int> broken, const Eigen::VectorXd& before,
                           const std::function<bool()>& looks_free);

}  // namespace bempd::fracture

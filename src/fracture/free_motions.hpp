#pragma once

#include <functional>
#include <vector>

#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Parts that had to be held to make equilibrium unique.
struct HeldMotions {
  std::vector<int> nodes;      // where a spring was put
  bool loads_lost = false;     // they pushed on something that moves freely
  std::int64_t fragments = 0;  // parts that lost them
};

// Solves the body's system and holds what the solution shows to be free, by springs that keep it where it is `before`.
// `looks_free` is asked after each solution; `broken` are the terms that broke last. Throws Error (unsolvable) where
// holding does not help.
HeldMotions solve_and_hold(LoadedBody& body, std::span<const int> broken, const Eigen::VectorXd& before,
                           const std::function<bool()>& looks_free);

}  // namespace bempd::fracture

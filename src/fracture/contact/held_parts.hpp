#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Parts of the body that only springs hold. They carry no force, so no crack face may press on them.
struct HeldParts {
  std::vector<char> nodes;               // flags of the nodes of pieces that only springs hold
  std::vector<Eigen::VectorXd> motions;  // motions within other pieces that only springs resist
  std::vector<char> all_nodes() const;   // flags of the nodes of all held parts
};

// Flags of the exact constraints that would push a held part: the gap of such a constraint changes in a motion that
// only springs resist.
std::vector<char> exact_constraints_that_push(const coupling::EquilibriumSystem& system,
                                              const std::vector<Point>& positions, const HeldParts& parts);

}  // namespace bempd::fracture

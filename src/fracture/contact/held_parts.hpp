#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Parts that springs hold where they are. They carry no force, so that no face of a crack may press on them.
struct HeldParts {
  std::vector<char> nodes;               // flags of the nodes of pieces that nothing else holds
  std::vector<Eigen::VectorXd> motions;  // of other parts, which nothing but springs resists
};

// Flags of the exact constraints that would push a held part: those whose gap changes with a motion that springs hold.
std::vector<char> exact_ones_that_push(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                                       const HeldParts& parts);

}  // namespace bempd::fracture

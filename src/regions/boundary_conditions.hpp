#pragma once

#include <string>
#include <vector>

#include "coupling/affine.hpp"
#include "regions/discretization.hpp"

namespace bempd::model {

// Supports and loads as values on the degrees of freedom of the scene's nodes (2 * node + component).
struct DofConditions {
  std::vector<char> prescribed;                 // per degree of freedom
  coupling::Affine displacement;                // of prescribed degrees of freedom [m]
  coupling::Affine force;                       // [N]
  std::vector<std::vector<int>> reaction_dofs;  // per support; a shared degree of freedom counts for the first one
};

// Throws Error (argument) for contradictory supports, tractions on interfaces, and places without a node.
DofConditions apply_conditions(const Scene& scene, const Discretization& discretization);

}  // namespace bempd::model

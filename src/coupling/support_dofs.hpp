#pragma once

#include <vector>

namespace bempd::coupling {

// Force that a support takes over from a degree of freedom, or leaves to another support if it is negative: the force
// on `dof` times `weight`, which acts at `node`.
struct SharedForce {
  int dof, node;
  double weight;
};

// Degrees of freedom whose forces each support counts, and what it takes over where supports share a node.
struct SupportDofs {
  std::vector<std::vector<int>> own;
  std::vector<std::vector<SharedForce>> shared;
};

}  // namespace bempd::coupling

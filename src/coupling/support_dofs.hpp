#pragma once

#include <vector>

namespace bempd::coupling {

// Force that a support counts besides its own forces: the force on `dof` times `weight`, which acts at `node`. A
// negative weight leaves a share of the support's own force to another support.
struct SharedForce {
  int dof, node;
  double weight;
};

// Degrees of freedom whose forces each support counts (`own`), and shares of forces where supports have a common node.
struct SupportDofs {
  std::vector<std::vector<int>> own;
  std::vector<std::vector<SharedForce>> shared;
};

}  // namespace bempd::coupling

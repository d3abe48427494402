#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

namespace bempd::coupling {

// What a region contributes to the equilibrium of shared nodes. Degrees of freedom are 2 * node + component.

// Stiffness [N/m] on the nodes listed, as a boundary element region has it; positive semidefinite where it is
// symmetric.
struct DenseOperator {
  std::vector<int> nodes;
  std::shared_ptr<const Eigen::MatrixXd> stiffness;  // operators that are alike have one
  bool symmetric = true;
};

// Pairwise bonds, as a lattice has them; structure of arrays because stepping sweeps over all of them at every event.
struct BondSet {
  std::vector<int> first, second;    // nodes
  std::vector<double> cosine, sine;  // unit vector from first to second
  std::vector<double> length;        // [m]
  std::vector<double> stiffness;     // force per elongation [N/m]

  std::size_t size() const { return first.size(); }

  double elongation(std::size_t bond, const double* displacement) const {
    const double* a = displacement + 2 * first[bond];
    const double* b = displacement + 2 * second[bond];
    return cosine[bond] * (b[0] - a[0]) + sine[bond] * (b[1] - a[1]);
  }
};

// A spring from the ground along a direction at a node. It holds a motion that nothing else resists, so in equilibrium
// it carries no force; `anchor` is the displacement along the direction at which it was attached [m].
struct HoldingSpring {
  int node;
  double cosine, sine;
  double stiffness;  // [N/m]
  double anchor;
};

}  // namespace bempd::coupling

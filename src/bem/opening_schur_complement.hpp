#pragma once

#include <Eigen/Core>
#include <vector>

namespace bempd::bem {

// Eliminates the openings w from a stiffness on displacements u and openings w, two components a node: K_ww = L L^T.
// The nodes have an order of their own, in which those that stay the same while cracks grow come first, so that their
// part of L is taken over.
class OpeningSchurComplement {
 public:
  // `before` is that of a body with other cracks, and `kept` the nodes of its unknowns by those here, -1 for new ones.
  // It is of use where all displacements are kept. Throws Error (argument) if a piece is cut out.
  void compute(const Eigen::MatrixXd& full, Eigen::Index displacements, const OpeningSchurComplement* before,
               const std::vector<int>& kept);

  const Eigen::MatrixXd& stiffness() const { return stiffness_; }                // of displacements
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& forces) const;  // K_ww^-1 forces
  Eigen::Index size() const { return factor_.rows(); }

 private:
  Eigen::Index take_over(const OpeningSchurComplement& before, Eigen::Index displacements,
                         const std::vector<int>& kept);
  void factorize(const Eigen::MatrixXd& full, Eigen::Index displacements, Eigen::Index known);

  std::vector<int> order_;         // nodes of openings among the unknowns
  Eigen::MatrixXd factor_, half_;  // L and L^-1 K_wu
  Eigen::MatrixXd stiffness_;
};

}  // namespace bempd::bem

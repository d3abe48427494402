#pragma once

#include <Eigen/Core>
#include <vector>

namespace bempd::bem {

// Schur complement that eliminates the openings w from a stiffness on displacements u and openings w, which have two
// components per node, with K_ww = L L^T. Opening nodes that stay the same while cracks grow come first in the order of
// elimination, so that their rows of L can be copied.
class OpeningSchurComplement {
 public:
  // Eliminates the openings from `full`, whose first `displacements` unknowns stay. `before` is the result for the body
  // with other cracks (null: none); its factor is used if the displacement nodes are the same in both bodies. `kept`
  // has for each node of the unknowns its number in `before`, or -1. Throws Error (argument) if cracks cut out a piece
  // that nothing holds.
  void compute(const Eigen::MatrixXd& full, Eigen::Index displacements, const OpeningSchurComplement* before,
               const std::vector<int>& kept);

  const Eigen::MatrixXd& stiffness() const { return stiffness_; }                // on displacements
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& forces) const;  // K_ww^-1 forces

 private:
  Eigen::Index take_over(const OpeningSchurComplement& before, Eigen::Index displacements,
                         const std::vector<int>& kept);
  void factorize(const Eigen::MatrixXd& full, Eigen::Index displacements, Eigen::Index known);

  std::vector<int> order_;         // opening nodes, as numbered among the unknowns
  Eigen::MatrixXd factor_, half_;  // L and L^-1 K_wu
  Eigen::MatrixXd stiffness_;
};

}  // namespace bempd::bem

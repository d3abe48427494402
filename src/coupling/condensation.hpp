#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Linear function of all displacements, expressed by the kept displacements: value = constant + weights . (kept
// displacements). Column 0 of `constant` does not depend on the load factor, column 1 is multiplied by it.
struct CondensedFunction {
  Eigen::VectorXd weights;
  Eigen::RowVector2d constant;
};

// Condensation of the whole body, under its present loads, onto the kept unknowns, which the factorization eliminates
// last. The object uses the system's factor, which must not change meanwhile.
class Condensation {
 public:
  // Prepares the condensation. Factorizes the present matrix unless the system has a factor of this matrix.
  explicit Condensation(EquilibriumSystem& system);

  // Kept degrees of freedom, in the order that all vectors and matrices of this class have.
  const std::vector<int>& dofs() const { return dofs_; }

  // Cholesky factor, a lower triangle, of the Schur complement on the kept degrees of freedom.
  const Eigen::MatrixXd& factor() const { return factor_; }

  // Loads and prescribed displacements of the whole body, condensed to forces on the kept degrees of freedom.
  Affine load() const;

  // Condenses linear functions of displacements. A column of `functions` has the weights of all degrees of freedom in
  // one function; weights of tied nodes are 0.
  std::vector<CondensedFunction> condense(const Eigen::MatrixXd& functions) const;

  // Computes states of the whole sparse system from their kept displacements, one column of `kept` per state. `part`
  // has one number per state: 0 if the state belongs to the constant part of the load, 1 if it belongs to the
  // proportional part. The result has one row per state and one column per degree of freedom; recover() adds degrees of
  // freedom inside dense operators.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& kept, const std::vector<int>& part) const;

  // Adds the displacements that the sparse system does not contain: displacements inside dense operators, and of tied
  // nodes.
  void recover(Affine& displacement) const;

  // Displacements of all nodes from the kept displacements.
  Affine displacement(const Affine& kept) const;
  Affine displacement_at(const std::vector<int>& nodes, const Affine& kept) const;  // others than `nodes` may be NaN

 private:
  FactorizedSystem system_;
  std::vector<int> dofs_;
  Eigen::MatrixXd factor_;
  Affine eliminated_;          // load after SparseCholesky::solve_forward()
  std::vector<int> place_of_;  // place of each degree of freedom in the order of elimination; -1: no unknown
};

}  // namespace bempd::coupling

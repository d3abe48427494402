#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Linear function of all displacements, expressed by the kept ones: value = constant + weights . (kept displacements).
// `constant` itself has a constant part and one that is proportional to the load factor.
struct CondensedFunction {
  Eigen::VectorXd weights;
  Eigen::RowVector2d constant;
};

// Condensation of the whole body, under its present loads, onto the kept unknowns: those that its factorization
// eliminates last. The object uses the system's factor, which must stay as it is.
class Condensation {
 public:
  // Prepares the condensation; factorizes if there is no factor of the present matrix yet.
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
  // tells for each state whether it belongs to the constant (0) or the proportional (1) part of the load. The result
  // has one row per state and one column per degree of freedom; those inside dense operators are left to recover().
  Eigen::MatrixXd expand(const Eigen::MatrixXd& kept, const std::vector<int>& part) const;

  // Adds the displacements that the sparse system does not contain: those inside dense operators, and of tied nodes.
  void recover(Affine& displacement) const;

  // Displacements of all nodes from the kept ones. displacement_at() guarantees those of `nodes` only: others may be
  // NaN.
  Affine displacement(const Affine& kept) const;
  Affine displacement_at(const std::vector<int>& nodes, const Affine& kept) const;

 private:
  FactorizedSystem system_;
  std::vector<int> dofs_;
  Eigen::MatrixXd factor_;
  Affine eliminated_;          // load after SparseCholesky::solve_forward()
  std::vector<int> place_of_;  // of a degree of freedom in the order of elimination; -1: it is no unknown
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Linear function of all displacements, expressed by the kept ones: value = constant + weights . displacement, where
// the constant has a constant and a proportional part of the load.
struct CondensedFunction {
  Eigen::VectorXd weights;
  Eigen::RowVector2d constant;
};

// Condensation of the whole body, under its present loads, onto the unknowns that its factorization keeps last: all
// others are eliminated. It uses the system's factor, which must stay as it is.
class Condensation {
 public:
  // Prepares the condensation; factorizes if there is no factor of the present matrix yet.
  explicit Condensation(EquilibriumSystem& system);

  // Kept degrees of freedom, in the order of all vectors here.
  const std::vector<int>& dofs() const { return dofs_; }

  // Cholesky factor of the Schur complement, a lower triangle.
  const Eigen::MatrixXd& factor() const { return factor_; }

  // Loads and prescribed displacements as forces on the kept degrees of freedom.
  Affine load() const;

  // Condenses functions whose columns are weights of all degrees of freedom (none on tied nodes).
  std::vector<CondensedFunction> condense(const Eigen::MatrixXd& functions) const;

  // Displacements of all nodes with bonds from columns of kept ones; `part` tells for each column whether it belongs to
  // the constant (0) or to the proportional (1) part of the load. One column per degree of freedom, one row per state.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& kept, const std::vector<int>& part) const;

  // Adds the displacements of nodes without bonds.
  void recover(Affine& displacement) const;

  // Displacements of all nodes; or correct ones of these nodes at least, while others may be NaN.
  Affine displacement(const Affine& kept) const;
  Affine displacement_at(const std::vector<int>& nodes, const Affine& kept) const;

 private:
  FactorizedSystem system_;
  std::vector<int> dofs_;
  Eigen::MatrixXd factor_;
  Affine eliminated_;          // L^-1 load
  std::vector<int> place_of_;  // of a degree of freedom in the order of elimination; -1: it is no unknown
};

}  // namespace bempd::coupling

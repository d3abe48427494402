#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::coupling {

enum class DofKind : char { prescribed, private_free, shared_free, tied };

// A dense operator whose private unknowns (free, and touched by no other operator) are eliminated once, so that only
// the unknowns it shares with others enter the sparse system.
class CondensedOperator {
 public:
  // `kind` tells for each global degree of freedom what it is. Throws Error (unsolvable) if the private part is
  // singular.
  CondensedOperator(DenseOperator source, const std::vector<DofKind>& kind);

  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& schur_complement() const { return schur_; }
  bool has_private_unknowns() const { return !private_.empty(); }
  // Of the private block, estimated; 1 if it is empty.
  double reciprocal_condition() const { return private_.empty() ? 1 : symmetric_ ? cholesky_.rcond() : lu_.rcond(); }

  // Condenses loads: adds to `load` (global) what the private forces and the prescribed displacements leave on the
  // shared unknowns, and keeps the private part for recover().
  void condense_load(const Affine& force, const Affine& prescribed, Affine& load);

  // Private displacements from the shared ones.
  void recover(Affine& displacement) const;

  // Moves the weights of a function of displacements from the private ones to the shared ones, and to the constants
  // that the present loads make of them.
  void condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const;

  // force += stiffness * displacement, on all of the operator's nodes.
  void add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) const;

 private:
  void eliminate_symmetric();
  void eliminate_unsymmetric();

  std::vector<int> all_, private_, shared_;  // global degrees of freedom
  Eigen::MatrixXd stiffness_;                // on all_
  bool symmetric_;
  // Of the private block: one of the two.
  Eigen::LLT<Eigen::MatrixXd> cholesky_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::MatrixXd transfer_;  // private displacements per shared displacement, sign reversed
  Eigen::MatrixXd schur_;
  std::vector<int> private_local_, shared_local_;
  Affine private_load_;  // private displacements with the shared unknowns held at 0
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <memory>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::coupling {

enum class DofKind : char { prescribed, private_free, shared_free, tied };

// The private unknowns of a stiffness (free, and touched by no other operator) eliminated. Degrees of freedom are the
// stiffness' own.
class Elimination {
 public:
  using Stiffness = std::shared_ptr<const Eigen::MatrixXd>;

  // Throws Error (unsolvable) if the private part is singular.
  Elimination(Stiffness stiffness, bool symmetric, std::vector<DofKind> kind);

  bool is_of(const Stiffness& stiffness, const std::vector<DofKind>& kind) const {
    return stiffness_ == stiffness && kind_ == kind;
  }
  const Eigen::MatrixXd& stiffness() const { return *stiffness_; }
  const std::vector<int>& private_dofs() const { return private_; }
  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& schur_complement() const { return schur_; }
  // Private displacements per shared displacement, sign reversed.
  const Eigen::MatrixXd& transfer() const { return transfer_; }
  // Private displacements to private forces, the shared ones held at 0.
  Affine solve_private(const Affine& force) const;
  // Of the private block, estimated; 1 if it is empty.
  double reciprocal_condition() const;

 private:
  void eliminate_symmetric();
  void eliminate_unsymmetric();

  Stiffness stiffness_;
  bool symmetric_;
  std::vector<DofKind> kind_;
  std::vector<int> private_, shared_;
  // Of the private block: one of the two.
  Eigen::LLT<Eigen::MatrixXd> cholesky_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::MatrixXd transfer_, schur_;
};

// A dense operator whose private unknowns are eliminated once, so that only the unknowns it shares with others enter
// the sparse system.
class CondensedOperator {
 public:
  // `kind` tells for each global degree of freedom what it is. The elimination is taken over from one of those built
  // before if it is the same. Throws Error (unsolvable) if the private part is singular.
  CondensedOperator(const DenseOperator& source, const std::vector<DofKind>& kind,
                    const std::vector<CondensedOperator>& built);

  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& schur_complement() const { return elimination_->schur_complement(); }
  bool has_factorized() const { return has_factorized_; }  // itself, not one before
  double reciprocal_condition() const { return elimination_->reciprocal_condition(); }

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
  std::shared_ptr<const Elimination> elimination_;
  bool has_factorized_ = false;
  std::vector<int> all_, private_, shared_;  // global degrees of freedom
  Affine private_load_;                      // private displacements with the shared unknowns held at 0
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/elimination.hpp"
#include "coupling/operators.hpp"

namespace bempd::coupling {

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
  // Whether it is on these nodes, in this order.
  bool is_on(const std::vector<int>& nodes) const;
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

  // force += stiffness * (displacement - rest), on all of the operator's nodes.
  void add_internal_force(const Eigen::VectorXd& displacement, double load_factor, Eigen::VectorXd& force) const;

  // Half of what these forces do on (displacement - rest), its derivative by the load factor alone, and the energy of
  // the proportional parts.
  double energy(const Eigen::VectorXd& displacement, double load_factor) const;
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;
  double unit_energy(const Eigen::VectorXd& proportional) const;

 private:
  Eigen::VectorXd elastic(const Eigen::VectorXd& displacement, double load_factor) const;  // displacement - rest

  std::shared_ptr<const Elimination> elimination_;
  Affine rest_;  // of all its degrees of freedom, or empty
  bool has_factorized_ = false;
  std::vector<int> all_, private_, shared_;  // global degrees of freedom
  Affine private_load_;                      // private displacements with the shared unknowns held at 0
};

}  // namespace bempd::coupling

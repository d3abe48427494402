#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"
#include "coupling/schur_complement.hpp"

namespace bempd::coupling {

// Schur complements of this and an earlier system, found by the stiffness matrix that they belong to.
using KnownSchurComplements = std::multimap<const Eigen::MatrixXd*, std::shared_ptr<const SchurComplement>>;

// Dense operator whose private unknowns are eliminated once, so that only the unknowns that it shares with other parts
// enter the sparse system.
class OperatorSchurComplement {
 public:
  // Condenses `source`; `kind` classifies every global degree of freedom. If `known` has the Schur complement, it is
  // used again; else a new one is made and added to `known`. Throws Error (unsolvable) if the private block is
  // singular.
  OperatorSchurComplement(const DenseOperator& source, const std::vector<DofKind>& kind, KnownSchurComplements& known);

  const std::shared_ptr<const SchurComplement>& schur() const { return schur_; }
  const std::shared_ptr<const ExactConstraints>& constraints() const { return constraints_; }
  const std::vector<Eigen::Index>& active() const { return active_; }  // numbers of the closed constraints
  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& schur_complement() const { return active_.empty() ? schur_->matrix() : schur_with_active_; }
  const Eigen::MatrixXd& schur_complement_when_open() const { return schur_->matrix(); }
  // Whether the operator's nodes are exactly these, in this order.
  bool is_on(const std::vector<int>& nodes) const;
  const Affine& rest() const { return rest_; }
  void exchange_rest(Affine& other) noexcept { rest_.swap(other); }  // condense_load() has to follow
  bool has_factorized() const { return has_factorized_; }            // a new Schur complement, not a known one
  double reciprocal_condition() const { return schur_->reciprocal_condition(); }

  // Condenses the loads: adds the effect of private forces and of prescribed displacements on the shared unknowns to
  // `load` (all degrees of freedom of the system), and keeps the private part for recover().
  void condense_load(const Affine& force, const Affine& prescribed, Affine& load);

  // Computes the displacements of private unknowns (those of this operator alone) from those of the shared unknowns.
  void recover(Affine& displacement) const;

  // Condenses a linear function of displacements: moves the `weights` of private displacements to the shared
  // displacements, and adds the contribution of the present loads to `constant` (constant and proportional part).
  void condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const;

  // Adds the forces of the operator to `force` on all of its nodes: stiffness * (displacement - rest), and the forces
  // of multipliers.
  void add_internal_force(const Eigen::VectorXd& displacement, double load_factor, Eigen::VectorXd& force) const;

  // Strain energy, half the stiffness times the square of (displacement - rest), and the energy of closed constraints.
  double energy(const Eigen::VectorXd& displacement, double load_factor) const;
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;  // by the load factor, u fixed
  double unit_energy(const Eigen::VectorXd& proportional) const;  // energy of the proportional parts

  // Number of exact unilateral constraints inside the operator (operator_constraints.cpp); all are open at first.

  std::size_t constraint_count() const {
    return constraints_ ? static_cast<std::size_t>(constraints_->of_forces.rows()) : 0;
  }
  // Sets the gaps that loads inside the body cause. condense_load() has to follow this and set_closed().
  void set_gap_offsets(const Eigen::Ref<const Affine>& offsets) { gap_offsets_ = offsets; }
  void set_closed(const std::vector<char>& closed);
  std::vector<char> closed() const;
  bool can_switch(Eigen::Index constraint) const { return can_switch_[static_cast<std::size_t>(constraint)] != 0; }
  // Gaps of all constraints. A closed constraint gets the gap that it would have without its multiplier, which is
  // negative while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Gaps from displacements and loads if all multipliers were zero.
  Eigen::VectorXd gaps_without_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  Eigen::VectorXd multipliers(const Eigen::VectorXd& displacement, double load_factor) const;  // contact forces [N]
  // Energy less half the product of displacements and operator forces; for operators without rest displacements.
  double energy_of_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Work of loads inside the body on the displacements that the multipliers cause.
  double work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Adds to `weights` the gap of a constraint as a linear function of displacements, numbered 2 * node + component. The
  // gap of an open constraint is this function plus the constraint's offset.
  void add_gap_function(Eigen::Index constraint, Eigen::Ref<Eigen::VectorXd> weights) const;

 private:
  void find_switchable();
  void eliminate_constraints();
  void find_gaps_at_rest(const Affine& support);
  void subtract_carried_by_closed(const Affine& support, Affine& load);
  Affine active_multipliers(const Affine& displacement) const;
  Eigen::VectorXd compliant_gaps(const Eigen::VectorXd& displacement, double load_factor) const;  // without multipliers

  Eigen::VectorXd elastic(const Eigen::VectorXd& displacement, double load_factor) const;  // displacement - rest

  std::shared_ptr<const SchurComplement> schur_;
  Affine rest_;  // rest displacements of all its degrees of freedom, or empty
  bool has_factorized_ = false;
  std::vector<int> all_, private_, shared_;  // global degrees of freedom
  Affine private_load_;                      // private displacements with the shared unknowns held at 0

  std::shared_ptr<const ExactConstraints> constraints_;
  Affine gap_offsets_;            // gaps due to loads inside the body
  std::vector<char> can_switch_;  // whether private displacements or its own multiplier can close a constraint
  // Active set: numbers of the closed constraints. `compliant_` has the numbers of those closed constraints whose own
  // multiplier would open their gap even with all displacements held.
  std::vector<Eigen::Index> active_, compliant_;
  // Private displacements per unit multiplier, gaps per unit multiplier and gaps per shared displacement; computed when
  // first needed.
  Eigen::MatrixXd private_by_forces_, gaps_by_forces_, gaps_by_shared_;
  // Factorized matrices of the gaps of closed constraints per unit multiplier: with the private unknowns free
  // (`active_compliance_`), and with all displacements held (`own_compliance_`).
  Eigen::LDLT<Eigen::MatrixXd> active_compliance_, own_compliance_;
  Eigen::MatrixXd schur_with_active_;
  Affine gaps_at_rest_;  // gaps with the shared unknowns held at 0, without multipliers
};

}  // namespace bempd::coupling

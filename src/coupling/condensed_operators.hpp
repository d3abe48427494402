#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operator_schur_complement.hpp"
#include "coupling/operators.hpp"
#include "coupling/solver_counters.hpp"

namespace bempd::coupling {

// Dense operators of a system, condensed onto the unknowns that they share with other parts. They are condensed once,
// when forces or energies are first needed. Loads are condensed again whenever they or the active set of constraints
// change.
class CondensedOperators {
 public:
  CondensedOperators() = default;
  explicit CondensedOperators(std::vector<DenseOperator> operators);

  bool are_condensed() const { return condensed_ != Condensed::nothing; }
  // Makes condense() copy the Schur complements of those operators that `before` has as well.
  void take_over(const CondensedOperators& before);
  // Condenses the operators onto their shared unknowns; `kind` classifies all degrees of freedom. Throws Error
  // (unsolvable) if the block of an operator's private unknowns (those that no other part of the system has) is
  // singular.
  void condense(const std::vector<DofKind>& kind, SolverCounters& counters);
  const std::vector<OperatorSchurComplement>& list() const { return list_; }  // empty until they are condensed
  // Index of the operator that has exactly these nodes; -1 if there is none.
  int number_on(const std::vector<int>& nodes) const;
  // Forces on all nodes by the operator that has exactly these nodes; 0 if there is no such operator.
  Eigen::VectorXd force_on(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                           double load_factor) const;

  // Condenses the loads: forces on private unknowns (those of one operator alone) and prescribed displacements become
  // forces on the shared unknowns.
  void condense_load(const Affine& force, const Affine& prescribed);
  void forget_load();
  const Affine& load() const { return load_; }

  // Rest displacements of every operator: displacements that need no force, as in a body that swells.
  std::vector<Affine> rests() const;
  void exchange_rests(std::vector<Affine>& others) noexcept;  // condense_load() has to follow
  // Whether some rest displacement is not zero in the constant (0) or the proportional (1) part.
  bool have_rest(int part) const { return have_rest_[part]; }
  double rest_motion(int part) const { return rest_motion_[part]; }  // largest rest displacement [m]

  // Number of exact unilateral constraints (condensed_constraints.cpp); they are numbered operator by operator.
  Eigen::Index constraint_count() const { return gap_offsets_.rows(); }
  // Flags of the constraints that are closed when a run goes on from `before`, a system with shorter cracks whose
  // closed constraints have the flag 1 in `closed`. A constraint is closed if it can close by itself and the nearest
  // constraint of `before` was closed.
  std::vector<char> closed_as_in(const CondensedOperators& before, const std::vector<char>& closed) const;
  // Sets which constraints are closed, by one flag for each constraint, and eliminates the closed ones; condense_load()
  // has to follow.
  void set_closed(const std::vector<char>& closed);
  // Gaps that loads inside the operators cause, one row per constraint.
  const Affine& gap_offsets() const { return gap_offsets_; }
  void exchange_gap_offsets(Affine& others) noexcept;  // condense_load() has to follow
  // Gaps of all constraints. A closed constraint gets the gap that it would have without its multiplier, which is
  // negative while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Gaps at a displacement and a load factor if all multipliers were zero.
  Eigen::VectorXd gaps_without_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Multipliers of all constraints, which are contact forces [N]; 0 for open ones.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Work of loads inside the operators on the displacements that the multipliers cause.
  double work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Adds to `weights` the gap of a constraint as a linear function of displacements, without its constant offset.
  void add_gap_function(Eigen::Index constraint, Eigen::VectorXd& weights) const;

 private:
  enum class Condensed : char { nothing, operators, operators_and_load };

  template <class Visit>
  void for_each_rest(const Visit& visit);
  void measure_rests() noexcept;

  std::vector<DenseOperator> pending_;  // operators until they are condensed
  std::vector<OperatorSchurComplement> list_;
  Condensed condensed_ = Condensed::nothing;
  KnownSchurComplements known_;  // Schur complements for condense(); empty afterwards
  Affine load_, gap_offsets_{0, 2};
  bool have_rest_[2] = {false, false};
  double rest_motion_[2] = {0, 0};
};

}  // namespace bempd::coupling

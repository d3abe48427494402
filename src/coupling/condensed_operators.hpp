#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operator_schur_complement.hpp"
#include "coupling/operators.hpp"
#include "coupling/solver_counters.hpp"

namespace bempd::coupling {

// Dense operators of a system. They are condensed once, when forces or energies are first needed, onto the unknowns
// that they share with other parts. Loads are condensed anew whenever they or the active set of constraints change.
class CondensedOperators {
 public:
  CondensedOperators() = default;
  explicit CondensedOperators(std::vector<DenseOperator> operators);

  bool are_condensed() const { return condensed_ != Condensed::nothing; }
  // Makes condense() take over the Schur complements of operators that are unchanged since `before`.
  void take_over(const CondensedOperators& before);
  // Condenses the operators; `kind` classifies all degrees of freedom. Throws Error (unsolvable) if the block of an
  // operator's private unknowns is singular.
  void condense(const std::vector<DofKind>& kind, SolverCounters& counters);
  const std::vector<OperatorSchurComplement>& list() const { return list_; }  // empty until they are condensed
  // Index of the operator on these nodes (-1: there is none), then its forces on all nodes (0 if there is none).
  int number_on(const std::vector<int>& nodes) const;
  Eigen::VectorXd force_on(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                           double load_factor) const;

  // Condenses the loads: forces on private unknowns and prescribed displacements become forces on the shared unknowns.
  void condense_load(const Affine& force, const Affine& prescribed);
  void forget_load();
  const Affine& load() const { return load_; }

  // Rest displacements, which need no force, of every operator; then, for the constant (0) or proportional (1) part,
  // whether any of them is not zero, and the largest [m].
  std::vector<Affine> rests() const;
  void exchange_rests(std::vector<Affine>& others) noexcept;  // condense_load() has to follow
  bool have_rest(int part) const { return have_rest_[part]; }
  double rest_motion(int part) const { return rest_motion_[part]; }

  // Number of exact unilateral constraints (condensed_constraints.cpp); they are numbered operator by operator.
  Eigen::Index constraint_count() const { return gap_offsets_.rows(); }
  // Flags of constraints that are closed at first when a run goes on from a system with shorter cracks (`before`): 1 if
  // a constraint can close by itself, and the one nearest to it there is flagged in `closed`.
  std::vector<char> closed_as_in(const CondensedOperators& before, const std::vector<char>& closed) const;
  // Sets which constraints are closed, one flag each, and eliminates the closed ones; condense_load() has to follow.
  void set_closed(const std::vector<char>& closed);
  // Gaps that loads inside operators cause, one row per constraint.
  const Affine& gap_offsets() const { return gap_offsets_; }
  void exchange_gap_offsets(Affine& others) noexcept;  // condense_load() has to follow
  // Gaps of all constraints. For a closed one it is the gap that it would have without its multiplier: negative while
  // its faces press.
  Affine gaps(const Affine& displacement) const;
  // Contact quantities at a displacement and a load factor: gaps if all multipliers were zero; the multipliers, which
  // are contact forces [N]; and the work of loads inside operators on the displacements that the multipliers cause.
  Eigen::VectorXd gaps_without_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  Eigen::VectorXd multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  double work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Adds to `weights` the gap of a constraint as a linear function of displacements, without its constant offset.
  void add_gap_function(Eigen::Index constraint, Eigen::VectorXd& weights) const;
  // Flags of the constraints of the operator on these nodes: 1 if closed. Empty if there is no such operator.
  std::vector<char> closed_on(const std::vector<int>& nodes) const;

 private:
  enum class Condensed : char { nothing, operators, operators_and_load };

  template <class Visit>
  void for_each_rest(const Visit& visit);
  void measure_rests() noexcept;

  std::vector<DenseOperator> pending_;  // until condensed
  std::vector<OperatorSchurComplement> list_;
  Condensed condensed_ = Condensed::nothing;
  KnownSchurComplements known_;  // until condensed
  Affine load_, gap_offsets_{0, 2};
  bool have_rest_[2] = {false, false};
  double rest_motion_[2] = {0, 0};
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operator_schur_complement.hpp"
#include "coupling/operators.hpp"
#include "coupling/solver_counters.hpp"

namespace bempd::coupling {

// The dense operators of a system. They are condensed onto the unknowns that they share once, when forces or energies
// are first asked for; loads are condensed anew after each change of theirs or of the active set.
class CondensedOperators {
 public:
  CondensedOperators() = default;
  explicit CondensedOperators(std::vector<DenseOperator> operators);

  bool are_condensed() const { return condensed_ != Condensed::nothing; }
  // Throws Error (unsolvable) if a private part is singular.
  void condense(const std::vector<DofKind>& kind, SolverCounters& counters);
  const std::vector<OperatorSchurComplement>& list() const { return list_; }  // empty until they are condensed
  // Number of the operator on these nodes, -1 if there is none; and its nodal forces, 0 if there is none.
  int number_on(const std::vector<int>& nodes) const;
  Eigen::VectorXd force_on(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                           double load_factor) const;

  // Forces on all nodes, with those of private unknowns and prescribed displacements moved to the shared unknowns.
  void condense_load(const Affine& force, const Affine& prescribed);
  void forget_load();
  const Affine& load() const { return load_; }

  // Rest displacements of every operator; whether some part of them is not zero; and the largest in each part [m].
  std::vector<Affine> rests() const;
  void exchange_rests(std::vector<Affine>& others) noexcept;  // condense_load() has to follow
  bool have_rest(int part) const { return have_rest_[part]; }
  double rest_motion(int part) const { return rest_motion_[part]; }

  // Exact unilateral constraints (condensed_constraints.cpp), numbered by operators.
  Eigen::Index constraint_count() const { return gap_offsets_.rows(); }
  // Eliminates those constraints that are closed; condense_load() has to follow.
  void set_closed(const std::vector<char>& closed);
  // Gaps that loads inside operators cause.
  const Affine& gap_offsets() const { return gap_offsets_; }
  void exchange_gap_offsets(Affine& others) noexcept;  // condense_load() has to follow
  // Gaps of open constraints. A closed one has the overlap that it would have without its multiplier.
  Affine gaps(const Affine& displacement) const;
  // Gaps where all multipliers are zero; the multipliers, which are contact forces [N]; and the work that loads inside
  // operators do on the displacements due to these.
  Eigen::VectorXd gaps_without_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  Eigen::VectorXd multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  double work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const;
  // Adds the gap of a constraint, without its offset, as a function of displacements.
  void add_gap_function(Eigen::Index constraint, Eigen::VectorXd& weights) const;
  // Flags of the constraints of the operator on these nodes: 1 if closed.
  std::vector<char> closed_on(const std::vector<int>& nodes) const;

 private:
  enum class Condensed : char { nothing, operators, operators_and_load };

  template <class Visit>
  void for_each_rest(const Visit& visit);
  void measure_rests() noexcept;

  std::vector<DenseOperator> pending_;  // until condensed
  std::vector<OperatorSchurComplement> list_;
  Condensed condensed_ = Condensed::nothing;
  Affine load_, gap_offsets_{0, 2};
  bool have_rest_[2] = {false, false};
  double rest_motion_[2] = {0, 0};
};

}  // namespace bempd::coupling

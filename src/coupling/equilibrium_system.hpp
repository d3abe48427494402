#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "coupling/contact_constraints.hpp"
#include "coupling/elastic_response.hpp"
#include "coupling/motion_resistance.hpp"
#include "coupling/repeatable_factor.hpp"
#include "coupling/stress_free_state.hpp"
#include "coupling/system_matrix.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// View of a system with a factor. Its references are valid as long as the system keeps this factor.
struct FactorizedSystem {
  const linalg::SparseCholesky& cholesky;
  const std::vector<int>& dof_of;  // degree of freedom of each unknown
  int kept;                        // number of unknowns that are eliminated last
  const std::vector<OperatorSchurComplement>& operators;
  const NodeTies& ties;
  const Affine& prescribed;
  Affine right_hand_side;  // one row per unknown
  SolverCounters& counters;
};

// Equilibrium of all nodes as one sparse system: dense operators condensed onto the unknowns that they share, energy
// terms (bonds and cell squares) and holding springs. The least demanding solution method that an operator names solves
// the system. Nothing is condensed or factorized before the first solve(). The system owns the parts below, and callers
// ask the part that they need.
class EquilibriumSystem {
 public:
  // Creates the system. Masters of tied nodes belong to dense operators. Tied nodes have energy terms only and cannot
  // be prescribed.
  EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, Terms terms,
                    const std::vector<char>& prescribed_dofs, NodeTies ties = {})
      : parts_(node_count, std::move(operators), std::move(terms), prescribed_dofs, std::move(ties)) {}
  EquilibriumSystem(const EquilibriumSystem&) = delete;
  EquilibriumSystem& operator=(const EquilibriumSystem&) = delete;

  // Copies from `before`, the system of a scene with shorter cracks, the results for parts that are the same.
  void take_over(const EquilibriumSystem& before) {
    parts_.operators.take_over(before.parts_.operators);
    factor_.take_over(before.factor_);
  }

  // Parts of the system in their present state.
  int node_count() const { return parts_.node_count; }
  const Terms& terms() const { return parts_.terms; }
  const TermStages& stages() const { return parts_.stages; }
  TermStages& stages() { return parts_.stages; }
  const NodeTies& ties() const { return parts_.ties; }
  const Unknowns& unknowns() const { return parts_.unknowns; }
  const DenseBodies& dense_bodies() const { return parts_.bodies; }
  const CondensedOperators& operators() const { return parts_.operators; }
  const std::vector<HoldingSpring>& springs() const { return parts_.springs; }
  const Constraints& constraints() const { return parts_.constraints; }
  const AppliedLoad& load() const { return parts_.load; }
  const StiffnessRange& stiffness_range() const { return parts_.stiffness; }
  bool is_symmetric() const { return parts_.is_symmetric(); }

  // Parts that evaluate the system or change it.
  const ElasticResponse& response() const { return response_; }
  const StressFreeState& stress_free() const { return stress_free_; }
  StressFreeState& stress_free() { return stress_free_; }
  const ContactConstraints& contact() const { return contact_; }
  ContactConstraints& contact() { return contact_; }
  const SystemMatrix& matrix() const { return matrix_; }
  SystemMatrix& matrix() { return matrix_; }
  RepeatableFactor& factor() { return factor_; }
  MotionResistance& motions() { return motions_; }

  // Sets the loads: forces [N] on free degrees of freedom and displacements [m] of prescribed degrees of freedom, both
  // numbered 2 * node + component.
  void set_load(Affine force, Affine prescribed);

  // Puts energy terms (bonds and cell squares) into other damage stages and adds holding springs. The matrix changes,
  // and its factor follows by low-rank changes.
  void commit(std::span<const StageChange> changes, std::span<const HoldingSpring> springs);
  // Replaces the damage stages of all energy terms and the holding springs; the next solve factorizes again.
  void restore(std::vector<std::uint8_t> stages, std::vector<HoldingSpring> springs);

  // Condenses the operators if they are not yet condensed; needed before forces and energies are computed.
  void condense() { parts_.condense(); }
  // Solves for the displacements in equilibrium. Throws Error (unsolvable) if some part of the body can move freely.
  Affine solve();
  // Factorizes the matrix unless a factor of it exists, and condenses the operators before. The system must be
  // symmetric. Throws Error (unsolvable).
  FactorizedSystem factorized();

  const SolverCounters& counters() const { return parts_.counters; }
  // Counts the reciprocal condition number of another matrix of the same body: the counters report the smallest number
  // of all matrices.
  void note_condition(double reciprocal) {
    parts_.counters.reciprocal_condition = std::min(parts_.counters.reciprocal_condition, reciprocal);
  }

 private:
  SystemParts parts_;
  SystemMatrix matrix_{parts_};
  RepeatableFactor factor_{parts_, matrix_};
  ElasticResponse response_{parts_};
  StressFreeState stress_free_{parts_.terms, parts_.operators};
  ContactConstraints contact_{parts_, factor_};
  MotionResistance motions_{parts_, matrix_, factor_};
};

}  // namespace bempd::coupling

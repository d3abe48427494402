#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/applied_load.hpp"
#include "coupling/condensed_operators.hpp"
#include "coupling/constraints.hpp"
#include "coupling/dense_bodies.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "coupling/solver_counters.hpp"
#include "coupling/term_stages.hpp"
#include "coupling/terms.hpp"
#include "coupling/unknowns.hpp"

namespace bempd::coupling {

// Range of the stiffnesses of single degrees of freedom [N/m] in a body, with the virgin stiffness of all energy terms.
// `smallest` is the least positive stiffness of all degrees of freedom. If the largest diagonal entry of some dense
// operator is even smaller, `smallest` is this entry.
struct StiffnessRange {
  StiffnessRange(int node_count, const std::vector<DenseOperator>& operators, const Terms& terms);
  double ratio() const { return largest > 0 ? smallest / largest : 1; }

  double smallest, largest = 0;
};

// Data of a system, from which its matrix and its right-hand side follow. The classes that solve with these data,
// change or evaluate them (RepeatableFactor, ContactConstraints, ElasticResponse and others) refer to one object of
// this class.
struct SystemParts {
  SystemParts(int nodes, std::vector<DenseOperator> dense_operators, Terms given_terms,
              const std::vector<char>& prescribed_dofs, NodeTies given_ties);
  SystemParts(const SystemParts&) = delete;
  SystemParts& operator=(const SystemParts&) = delete;

  // Condenses the operators if they are not yet condensed; needed before forces and energies are computed.
  void condense();
  // Condenses the operators if they are not yet condensed, then the loads onto the operators' shared unknowns.
  void condense_load();
  // Displacements of all nodes from the unknowns; prescribed displacements are set to 0.
  Eigen::VectorXd displacement_of(const Eigen::VectorXd& of_unknowns) const;
  bool is_symmetric() const { return method.needs_symmetry(); }

  int node_count;
  const SolutionMethod& method;
  Terms terms;
  NodeTies ties;
  TermStages stages;
  Unknowns unknowns;
  DenseBodies bodies;
  StiffnessRange stiffness;
  CondensedOperators operators;
  Constraints constraints;
  std::vector<HoldingSpring> springs;
  AppliedLoad load;
  SolverCounters counters;
};

}  // namespace bempd::coupling

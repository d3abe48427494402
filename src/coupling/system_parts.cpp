#include "coupling/system_parts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

const SolutionMethod& least_demanding(const std::vector<DenseOperator>& operators) {
  const SolutionMethod* method = &symmetric_solution();
  for (const DenseOperator& op : operators) {
    if (!op.method->needs_symmetry()) method = op.method;
  }
  return *method;
}

// Ratio of the smallest to the largest stiffness of a system below which digits are lost, because rounding errors in
// the stiffest part act as forces on the softest part.
constexpr double ordinary_stiffness_ratio = 1e-6;

}  // namespace

StiffnessRange::StiffnessRange(int node_count, const std::vector<DenseOperator>& operators, const Terms& terms)
    : smallest(std::numeric_limits<double>::infinity()) {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(2 * node_count);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    terms.for_each_entry(t, [&](int node, double x, double y) {
      diagonal[2 * node] += terms.stiffness[t] * x * x;
      diagonal[2 * node + 1] += terms.stiffness[t] * y * y;
    });
  }
  double least_of_operators = smallest;  // least of the operators' largest stiffnesses
  for (const DenseOperator& op : operators) {
    const Eigen::VectorXd own = op.stiffness->diagonal();
    for (std::size_t i = 0; i < op.nodes.size(); ++i)
      diagonal.segment<2>(2 * op.nodes[i]) += own.segment<2>(2 * static_cast<Eigen::Index>(i));
    least_of_operators = std::min(least_of_operators, own.maxCoeff());
  }
  if (diagonal.size() > 0) largest = diagonal.maxCoeff();
  for (double k : diagonal) {
    if (k > 0) smallest = std::min(smallest, k);
  }
  smallest = std::min(smallest, least_of_operators);
}

SystemParts::SystemParts(int nodes, std::vector<DenseOperator> dense_operators, Terms given_terms,
                         const std::vector<char>& prescribed_dofs, NodeTies given_ties)
    : node_count(nodes),
      method(least_demanding(dense_operators)),
      terms(std::move(given_terms)),
      ties(std::move(given_ties)),
      stages(terms),
      unknowns(classify(nodes, dense_operators, terms, ties, prescribed_dofs)),
      bodies(nodes, dense_operators, ties),
      stiffness(nodes, dense_operators, terms),
      operators(std::move(dense_operators)),
      constraints(static_cast<std::size_t>(operators.constraint_count())),
      load(nodes) {
  counters.sparse_unknowns = unknowns.count();
}

void SystemParts::condense() {
  if (operators.are_condensed()) return;
  const Stopwatch watch(counters.seconds_assembly);
  operators.condense(unknowns.kind, counters);
  if (stiffness.ratio() < ordinary_stiffness_ratio) counters.reciprocal_condition *= stiffness.ratio();
  operators.set_closed(constraints.closed_exact());
}

void SystemParts::condense_load() {
  condense();
  operators.condense_load(load.force(), load.prescribed());
}

Eigen::VectorXd SystemParts::displacement_of(const Eigen::VectorXd& of_unknowns) const {
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(2 * node_count);
  displacement(unknowns.dof_of) = of_unknowns;
  ties.expand(displacement);
  return displacement;
}

}  // namespace bempd::coupling

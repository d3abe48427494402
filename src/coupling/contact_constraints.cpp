#include "coupling/contact_constraints.hpp"

namespace bempd::coupling {

// Passes the active set of the exact constraints on to the operators, and condenses the loads for this set.
void ContactConstraints::eliminate_exact_ones() {
  parts_.operators.set_closed(parts_.constraints.closed_exact());
  factor_.forget();
  if (parts_.constraints.closed_exact_count() > 0) parts_.condense_load();
}

void ContactConstraints::set(Constraints constraints) {
  Constraints& present = parts_.constraints;
  const bool exact_ones_switch = constraints.closed_exact() != present.closed_exact();
  if (exact_ones_switch) parts_.condense();
  if (constraints.closed_penalty_count() > 0 || present.closed_penalty_count() > 0) factor_.forget();
  present = std::move(constraints);
  if (exact_ones_switch) eliminate_exact_ones();
}

void ContactConstraints::switch_over(std::span<const int> numbers) {
  Constraints& constraints = parts_.constraints;
  MatrixChange change(parts_.unknowns, parts_.ties);
  std::vector<std::size_t> exact;
  for (const int number : numbers) {
    const auto i = static_cast<std::size_t>(number);
    if (constraints[i].is_exact()) {
      exact.push_back(i);
      continue;
    }
    const bool closes = !constraints.is_closed(i);
    constraints.set_closed(i, closes);
    change.switch_penalty(constraints[i], closes);
  }
  factor_.change(change);
  if (exact.empty()) return;
  parts_.condense();
  for (const std::size_t i : exact) constraints.set_closed(i, !constraints.is_closed(i));
  eliminate_exact_ones();
}

Affine ContactConstraints::gaps(const Affine& displacement) const {
  const Constraints& constraints = parts_.constraints;
  Affine gaps(static_cast<Eigen::Index>(constraints.size()), 2);
  gaps.topRows(parts_.operators.constraint_count()) = parts_.operators.gaps(displacement);
  for (std::size_t i = constraints.exact_count(); i < constraints.size(); ++i)
    for (const int part : {0, 1})
      gaps(static_cast<Eigen::Index>(i), part) = constraints[i].gap(displacement.col(part).data());
  return gaps;
}

Eigen::VectorXd ContactConstraints::gap_function(std::size_t number) const {
  const Constraint& constraint = parts_.constraints[number];
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * parts_.node_count);
  for (const TermEntry& e : constraint.pull) weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
  parts_.ties.collect(weights);
  if (constraint.is_exact()) parts_.operators.add_gap_function(static_cast<Eigen::Index>(number), weights);
  return weights;
}

}  // namespace bempd::coupling

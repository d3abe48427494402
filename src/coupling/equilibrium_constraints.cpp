// Unilateral constraints of a system: their gaps, and changes of the active set.
#include <cmath>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Passes the active set of the exact constraints on to the operators, and condenses the loads for it.
void EquilibriumSystem::eliminate_exact_constraints() {
  operators_.set_closed(constraints_.closed_exact());
  forget_factor();
  if (constraints_.closed_exact_count() > 0) condense_load();
}

void EquilibriumSystem::set_constraints(Constraints constraints) {
  const bool exact_ones_switch = constraints.closed_exact() != constraints_.closed_exact();
  if (exact_ones_switch) condense();
  if (constraints.closed_penalty_count() > 0 || constraints_.closed_penalty_count() > 0) forget_factor();
  constraints_ = std::move(constraints);
  if (exact_ones_switch) eliminate_exact_constraints();
}

void EquilibriumSystem::switch_constraints(std::span<const int> numbers) {
  std::vector<Eigen::Triplet<double>> added, removed;
  std::vector<std::size_t> exact;
  int columns_added = 0, columns_removed = 0;
  std::vector<UnknownEntry> pull;
  for (const int number : numbers) {
    const auto i = static_cast<std::size_t>(number);
    const Constraint& constraint = constraints_[i];
    if (constraint.is_exact()) {
      exact.push_back(i);
      continue;
    }
    const bool closes = !constraints_.is_closed(i);
    constraints_.set_closed(i, closes);
    pull.clear();
    for (const TermEntry& e : constraint.pull)
      append_pull(unknowns_.unknown_of, ties_, e.node, e.x, e.y, std::sqrt(constraint.stiffness), pull);
    const int column = closes ? columns_added++ : columns_removed++;
    for (const UnknownEntry& e : pull) (closes ? added : removed).emplace_back(e.unknown, column, e.weight);
  }
  change_factor(added, columns_added, linalg::Change::add);
  change_factor(removed, columns_removed, linalg::Change::remove);
  if (exact.empty()) return;
  condense();
  for (const std::size_t i : exact) constraints_.set_closed(i, !constraints_.is_closed(i));
  eliminate_exact_constraints();
}

Affine EquilibriumSystem::gaps(const Affine& displacement) const {
  Affine gaps(static_cast<Eigen::Index>(constraints_.size()), 2);
  gaps.topRows(operators_.constraint_count()) = operators_.gaps(displacement);
  for (std::size_t i = constraints_.exact_count(); i < constraints_.size(); ++i)
    for (const int part : {0, 1})
      gaps(static_cast<Eigen::Index>(i), part) = constraints_[i].gap(displacement.col(part).data());
  return gaps;
}

Eigen::VectorXd EquilibriumSystem::gap_function(std::size_t number) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * node_count_);
  for (const TermEntry& e : constraints_[number].pull) weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
  ties_.collect(weights);
  if (constraints_[number].is_exact()) operators_.add_gap_function(static_cast<Eigen::Index>(number), weights);
  return weights;
}

}  // namespace bempd::coupling

// Unilateral constraints of a system: their gaps, and changes of the active set.
#include <cmath>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

namespace {

// Calls visit(operator, number of its first constraint, how many it has) for the operators with exact constraints.
template <class Operators, class Visit>
void for_each_constrained(Operators& operators, const Visit& visit) {
  Eigen::Index first = 0;
  for (auto& op : operators) {
    const auto count = static_cast<Eigen::Index>(op.constraint_count());
    if (count > 0) visit(op, first, count);
    first += count;
  }
}

}  // namespace

// Tells the operators their gap offsets and which of their constraints are closed.
void EquilibriumSystem::enter_exact_constraints() {
  for_each_constrained(operators_, [&](OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    op.set_gap_offsets(gap_offsets_.middleRows(first, count));
    const auto begin = constraints_.closed().begin() + first;
    op.set_closed({begin, begin + count});
  });
}

// Makes operators and loads follow exact constraints that have closed or opened.
void EquilibriumSystem::eliminate_exact_constraints() {
  enter_exact_constraints();
  forget_factor();
  condensed_ = Condensed::operators;
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

void EquilibriumSystem::exchange_gap_offsets(Affine& others) noexcept {
  gap_offsets_.swap(others);
  for_each_constrained(operators_, [&](OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    op.set_gap_offsets(gap_offsets_.middleRows(first, count));
  });
  if (condensed_ == Condensed::operators_and_load) condensed_ = Condensed::operators;
}

Affine EquilibriumSystem::gaps(const Affine& displacement) const {
  Affine gaps = Affine::Zero(static_cast<Eigen::Index>(constraints_.size()), 2);
  for_each_constrained(operators_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    gaps.middleRows(first, count) = op.gaps(displacement);
  });
  for (std::size_t i = constraints_.exact_count(); i < constraints_.size(); ++i)
    for (const int part : {0, 1})
      gaps(static_cast<Eigen::Index>(i), part) = constraints_[i].gap(displacement.col(part).data());
  return gaps;
}

Eigen::VectorXd EquilibriumSystem::exact_gaps(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(gap_offsets_.rows());
  for_each_constrained(operators_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    gaps.segment(first, count) = op.gaps_without_multipliers(displacement, load_factor);
  });
  return gaps;
}

Eigen::VectorXd EquilibriumSystem::multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(gap_offsets_.rows());
  for_each_constrained(operators_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    forces.segment(first, count) = op.multipliers(displacement, load_factor);
  });
  return forces;
}

double EquilibriumSystem::work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  double sum = 0;
  for (const OperatorSchurComplement& op : operators_) sum += op.work_due_to_multipliers(displacement, load_factor);
  return sum;
}

std::vector<char> EquilibriumSystem::closed_on(const std::vector<int>& nodes) const {
  std::vector<char> closed;
  for_each_constrained(operators_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    const auto begin = constraints_.closed().begin() + first;
    if (op.is_on(nodes)) closed.assign(begin, begin + count);
  });
  return closed;
}

Eigen::VectorXd EquilibriumSystem::gap_function(std::size_t number) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * node_count_);
  for (const TermEntry& e : constraints_[number].pull) weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
  ties_.collect(weights);
  const auto its = static_cast<Eigen::Index>(number);
  for_each_constrained(operators_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    if (its >= first && its < first + count) op.add_gap_function(its - first, weights);
  });
  return weights;
}

}  // namespace bempd::coupling

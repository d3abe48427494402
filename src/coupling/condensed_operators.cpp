#include "coupling/condensed_operators.hpp"

#include <algorithm>
#include <utility>

#include "cancellation.hpp"

namespace bempd::coupling {

CondensedOperators::CondensedOperators(std::vector<DenseOperator> operators) : pending_(std::move(operators)) {
  Eigen::Index constraints = 0;
  for (const DenseOperator& op : pending_)
    if (op.constraints) constraints += op.constraints->of_forces.rows();
  gap_offsets_ = Affine::Zero(constraints, 2);
  measure_rests();
}

void CondensedOperators::condense(const std::vector<DofKind>& kind, SolverCounters& counters) {
  list_.clear();  // left by an attempt that failed
  list_.reserve(pending_.size());
  for (const DenseOperator& op : pending_) {
    check_cancelled();
    list_.emplace_back(op, kind, known_);
    counters.dense_factorizations += list_.back().has_factorized() ? 1 : 0;
    counters.reciprocal_condition = std::min(counters.reciprocal_condition, list_.back().reciprocal_condition());
  }
  pending_.clear();
  known_.clear();
  condensed_ = Condensed::operators;
}

void CondensedOperators::take_over(const CondensedOperators& before) {
  known_ = before.known_;
  for (const OperatorSchurComplement& op : before.list_) known_.emplace(&op.schur()->stiffness(), op.schur());
}

int CondensedOperators::number_on(const std::vector<int>& nodes) const {
  const auto found = std::find_if(list_.begin(), list_.end(), [&](const auto& op) { return op.is_on(nodes); });
  return found == list_.end() ? -1 : static_cast<int>(found - list_.begin());
}

Eigen::VectorXd CondensedOperators::force_on(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                                             double load_factor) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  for (const OperatorSchurComplement& op : list_)
    if (op.is_on(nodes)) op.add_internal_force(displacement, load_factor, force);
  return force;
}

void CondensedOperators::condense_load(const Affine& force, const Affine& prescribed) {
  if (condensed_ == Condensed::operators_and_load) return;
  load_ = force;
  for (OperatorSchurComplement& op : list_) {
    check_cancelled();
    op.condense_load(force, prescribed, load_);
  }
  condensed_ = Condensed::operators_and_load;
}

void CondensedOperators::forget_load() {
  if (condensed_ == Condensed::operators_and_load) condensed_ = Condensed::operators;
}

template <class Visit>
void CondensedOperators::for_each_rest(const Visit& visit) {
  std::size_t number = 0;
  for (DenseOperator& op : pending_) visit(op.rest, number++);
  if (!are_condensed()) return;
  for (OperatorSchurComplement& op : list_) {
    Affine rest(0, 2);
    op.exchange_rest(rest);
    visit(rest, number++);
    op.exchange_rest(rest);
  }
}

void CondensedOperators::measure_rests() noexcept {
  for (int part = 0; part < 2; ++part) {
    have_rest_[part] = false;
    rest_motion_[part] = 0;
    for_each_rest([&](const Affine& rest, std::size_t) {
      have_rest_[part] = have_rest_[part] || !rest.col(part).isZero(0);
      if (rest.rows() > 0) rest_motion_[part] = std::max(rest_motion_[part], rest.col(part).lpNorm<Eigen::Infinity>());
    });
  }
}

std::vector<Affine> CondensedOperators::rests() const {
  std::vector<Affine> all;
  for (const DenseOperator& op : pending_) all.push_back(op.rest);
  if (!are_condensed()) return all;
  for (const OperatorSchurComplement& op : list_) all.push_back(op.rest());
  return all;
}

void CondensedOperators::exchange_rests(std::vector<Affine>& others) noexcept {
  for_each_rest([&](Affine& rest, std::size_t number) { rest.swap(others[number]); });
  measure_rests();
  forget_load();
}

}  // namespace bempd::coupling

#include "coupling/condensation.hpp"

#include <cassert>

#include "linalg/sparse_cholesky.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

Condensation::Condensation(EquilibriumSystem& system) : system_(system) {
  system_.condense();
  system_.factorize();
  const Stopwatch watch(system_.counters_.seconds_solve);
  system_.condense_load();
  const linalg::SparseCholesky& cholesky = system_.cholesky();
  const std::vector<int>& order = cholesky.elimination_order();
  for (auto it = order.end() - system_.kept_; it != order.end(); ++it) dofs_.push_back(system_.dof_of_[*it]);
  factor_ = cholesky.trailing_factor(system_.kept_);
  eliminated_ = system_.right_hand_side();
  cholesky.solve_forward(eliminated_);
}

std::vector<CondensedFunction> Condensation::condense(const Eigen::MatrixXd& functions) const {
  const Stopwatch watch(system_.counters_.seconds_solve);
  const auto kept = static_cast<Eigen::Index>(dofs_.size());
  std::vector<CondensedFunction> result;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(system_.dof_of_.size()), functions.cols());
  for (Eigen::Index k = 0; k < functions.cols(); ++k) {
    Eigen::VectorXd weights = functions.col(k);
    Eigen::RowVector2d constant = weights.transpose() * system_.prescribed_;
    for (const CondensedOperator& op : system_.operators_) op.condense_function(weights, constant);
    rows.col(k) = weights(system_.dof_of_);
    result.push_back({{}, constant});
  }
  system_.cholesky().solve_forward(rows);
  const Eigen::Index others = rows.rows() - kept;
  const Eigen::MatrixXd weights = factor_.triangularView<Eigen::Lower>() * rows.bottomRows(kept);
  const Eigen::MatrixXd eliminated = rows.topRows(others).transpose() * eliminated_.topRows(others);
  for (Eigen::Index k = 0; k < functions.cols(); ++k) {
    result[static_cast<std::size_t>(k)].weights = weights.col(k);
    result[static_cast<std::size_t>(k)].constant += eliminated.row(k);
  }
  return result;
}

Eigen::MatrixXd Condensation::expand(const Eigen::MatrixXd& kept, const std::vector<int>& part) const {
  const Stopwatch watch(system_.counters_.seconds_solve);
  const std::vector<int>& order = system_.cholesky().elimination_order();
  const Eigen::Index others = eliminated_.rows() - kept.rows();
  Eigen::MatrixXd unknowns(kept.cols(), eliminated_.rows());
  unknowns.leftCols(others) = eliminated_.topRows(others).transpose()(part, Eigen::all);
  unknowns.rightCols(kept.rows()) = kept.transpose();
  system_.cholesky().solve_backward(unknowns, static_cast<int>(kept.rows()));
  ++system_.counters_.solves;
  Eigen::MatrixXd all = system_.prescribed_.transpose()(part, Eigen::all);
  for (Eigen::Index k = 0; k < unknowns.cols(); ++k) {
    all.col(system_.dof_of_[order[static_cast<std::size_t>(k)]]) = unknowns.col(k);
  }
  system_.ties_.expand_rows(all);
  return all;
}

Affine Condensation::displacement(const Affine& kept) const {
  Affine all = Affine::Zero(2 * system_.node_count(), 2);
  const bool has_constant_part = !(kept.col(0).isZero(0) && eliminated_.col(0).isZero(0));
  if (has_constant_part) {
    all = expand(kept, {0, 1}).transpose();
  } else {
    all.col(0) = system_.prescribed_.col(0);
    all.col(1) = expand(kept.col(1), {1}).transpose();
  }
  recover(all);
  return all;
}

void Condensation::recover(Affine& displacement) const {
  for (const CondensedOperator& op : system_.operators_) op.recover(displacement);
  system_.ties_.expand(displacement);
}

}  // namespace bempd::coupling

#include "coupling/condensation.hpp"

#include <limits>
#include <utility>

#include "cancellation.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

Condensation::Condensation(EquilibriumSystem& system) : system_(system.factorized()) {
  const Stopwatch watch(system_.counters.seconds_solve);
  const std::vector<int>& order = system_.cholesky.elimination_order();
  for (auto it = order.end() - system_.kept; it != order.end(); ++it) dofs_.push_back(system_.dof_of[*it]);
  factor_ = system_.cholesky.trailing_factor(system_.kept);
  eliminated_ = std::move(system_.right_hand_side);
  system_.cholesky.solve_forward(eliminated_);
  check_cancelled();
  place_of_.assign(static_cast<std::size_t>(system_.prescribed.rows()), -1);
  for (std::size_t k = 0; k < order.size(); ++k) place_of_[system_.dof_of[order[k]]] = static_cast<int>(k);
}

Affine Condensation::load() const {
  return factor_.triangularView<Eigen::Lower>() * eliminated_.bottomRows(factor_.rows());
}

std::vector<CondensedFunction> Condensation::condense(const Eigen::MatrixXd& functions) const {
  const Stopwatch watch(system_.counters.seconds_solve);
  const auto kept = static_cast<Eigen::Index>(dofs_.size());
  std::vector<CondensedFunction> result;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(system_.dof_of.size()), functions.cols());
  for (Eigen::Index k = 0; k < functions.cols(); ++k) {
    check_cancelled();
    Eigen::VectorXd weights = functions.col(k);
    Eigen::RowVector2d constant = weights.transpose() * system_.prescribed;
    for (const OperatorSchurComplement& op : system_.operators) op.condense_function(weights, constant);
    rows.col(k) = weights(system_.dof_of);
    result.push_back({{}, constant});
  }
  system_.cholesky.solve_forward(rows);
  check_cancelled();
  const Eigen::MatrixXd weights = factor_.triangularView<Eigen::Lower>() * rows.bottomRows(kept);
  const Eigen::MatrixXd eliminated = system_.cholesky.eliminated_products(rows, eliminated_, static_cast<int>(kept));
  for (Eigen::Index k = 0; k < functions.cols(); ++k) {
    result[static_cast<std::size_t>(k)].weights = weights.col(k);
    result[static_cast<std::size_t>(k)].constant += eliminated.row(k);
  }
  return result;
}

Eigen::MatrixXd Condensation::expand(const Eigen::MatrixXd& kept, const std::vector<int>& part) const {
  const Stopwatch watch(system_.counters.seconds_solve);
  const std::vector<int>& order = system_.cholesky.elimination_order();
  const Eigen::Index eliminated = eliminated_.rows() - kept.rows();
  Eigen::MatrixXd unknowns(kept.cols(), eliminated_.rows());
  unknowns.leftCols(eliminated) = eliminated_.topRows(eliminated).transpose()(part, Eigen::all);
  unknowns.rightCols(kept.rows()) = kept.transpose();
  system_.cholesky.solve_backward(unknowns, static_cast<int>(kept.rows()));
  ++system_.counters.solves;
  Eigen::MatrixXd all = system_.prescribed.transpose()(part, Eigen::all);
  for (Eigen::Index k = 0; k < unknowns.cols(); ++k) {
    all.col(system_.dof_of[order[static_cast<std::size_t>(k)]]) = unknowns.col(k);
  }
  system_.ties.expand_rows(all);
  return all;
}

Affine Condensation::displacement(const Affine& kept) const {
  Affine all = Affine::Zero(system_.prescribed.rows(), 2);
  const bool has_constant_part = !(kept.col(0).isZero(0) && eliminated_.col(0).isZero(0));
  if (has_constant_part) {
    all = expand(kept, {0, 1}).transpose();
  } else {
    all.col(0) = system_.prescribed.col(0);
    all.col(1) = expand(kept.col(1), {1}).transpose();
  }
  recover(all);
  return all;
}

// All displacements are computed in two cases: if nodes are tied, because tied nodes follow other nodes; and if the
// load has a constant part, because one full solution for both parts is as fast as a partial solution for each.
Affine Condensation::displacement_at(const std::vector<int>& nodes, const Affine& kept) const {
  const bool has_constant_part = !(kept.col(0).isZero(0) && eliminated_.col(0).isZero(0));
  if (has_constant_part || !system_.ties.empty()) return displacement(kept);
  const Stopwatch watch(system_.counters.seconds_solve);
  std::vector<int> places;
  for (const int node : nodes)
    for (int dof = 2 * node; dof < 2 * node + 2; ++dof)
      if (place_of_[dof] >= 0) places.push_back(place_of_[dof]);
  const Eigen::Index eliminated = eliminated_.rows() - kept.rows();
  Eigen::MatrixXd unknowns(1, eliminated_.rows());
  unknowns.leftCols(eliminated) = eliminated_.col(1).head(eliminated).transpose();
  unknowns.rightCols(kept.rows()) = kept.col(1).transpose();
  system_.cholesky.solve_backward_at(places, unknowns, static_cast<int>(kept.rows()));
  Affine all = system_.prescribed;
  const std::vector<int>& order = system_.cholesky.elimination_order();
  for (const int dof : system_.dof_of) all(dof, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const int place : places) all(system_.dof_of[order[place]], 1) = unknowns(0, place);
  return all;
}

void Condensation::recover(Affine& displacement) const {
  for (const OperatorSchurComplement& op : system_.operators) op.recover(displacement);
  system_.ties.expand(displacement);
}

}  // namespace bempd::coupling

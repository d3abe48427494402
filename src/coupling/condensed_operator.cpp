#include "coupling/condensed_operator.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"

namespace bempd::coupling {

namespace {

[[noreturn]] void fail_singular() {
  fail(
      Failure::unsolvable,
      "the stiffness of a boundary element region is numerically singular; check its supports, and its shape for parts "
      "that are very thin");
}

// Reciprocal condition below which a solution carries no digit.
constexpr double singular_condition = 1e-16;

}  // namespace

Elimination::Elimination(Stiffness stiffness, bool symmetric, std::vector<DofKind> kind)
    : stiffness_(std::move(stiffness)), symmetric_(symmetric), kind_(std::move(kind)) {
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    if (kind_[i] == DofKind::private_free) private_.push_back(static_cast<int>(i));
    if (kind_[i] == DofKind::shared_free) shared_.push_back(static_cast<int>(i));
  }
  schur_ = (*stiffness_)(shared_, shared_);
  if (private_.empty()) return;
  if (symmetric_) {
    eliminate_symmetric();
  } else {
    eliminate_unsymmetric();
  }
}

void Elimination::eliminate_symmetric() {
  cholesky_.compute((*stiffness_)(private_, private_));
  if (cholesky_.info() != Eigen::Success) fail_singular();
  if (shared_.empty()) return;
  const Eigen::MatrixXd coupling = (*stiffness_)(private_, shared_);
  const Eigen::MatrixXd half = cholesky_.matrixL().solve(coupling);
  schur_.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose(), -1.0);
  schur_.triangularView<Eigen::StrictlyUpper>() = schur_.transpose();
  transfer_ = cholesky_.matrixU().solve(half);
}

void Elimination::eliminate_unsymmetric() {
  lu_.compute((*stiffness_)(private_, private_));
  if (!(lu_.rcond() > singular_condition)) fail_singular();
  if (shared_.empty()) return;
  transfer_ = lu_.solve((*stiffness_)(private_, shared_));
  schur_.noalias() -= (*stiffness_)(shared_, private_) * transfer_;
}

Affine Elimination::solve_private(const Affine& force) const {
  if (symmetric_) return cholesky_.solve(force);
  return lu_.solve(force);
}

double Elimination::reciprocal_condition() const {
  return private_.empty() ? 1 : symmetric_ ? cholesky_.rcond() : lu_.rcond();
}

CondensedOperator::CondensedOperator(const DenseOperator& source, const std::vector<DofKind>& kind,
                                     const std::vector<CondensedOperator>& built) {
  for (int node : source.nodes) all_.insert(all_.end(), {2 * node, 2 * node + 1});
  std::vector<DofKind> own;
  for (int dof : all_) own.push_back(kind[dof]);
  const auto same = std::find_if(built.begin(), built.end(), [&](const CondensedOperator& other) {
    return other.elimination_->is_of(source.stiffness, own);
  });
  if (same != built.end()) {
    elimination_ = same->elimination_;
  } else {
    elimination_ = std::make_shared<const Elimination>(source.stiffness, source.symmetric, std::move(own));
    has_factorized_ = !elimination_->private_dofs().empty();
  }
  for (int i : elimination_->private_dofs()) private_.push_back(all_[i]);
  for (int i : elimination_->shared_dofs()) shared_.push_back(all_[i]);
}

void CondensedOperator::condense_load(const Affine& force, const Affine& prescribed, Affine& load) {
  const Eigen::MatrixXd& stiffness = elimination_->stiffness();
  const std::vector<int>&private_local = elimination_->private_dofs(), &shared_local = elimination_->shared_dofs();
  const Affine support = prescribed(all_, Eigen::all);
  const Affine reaction = stiffness * support;
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= reaction.row(shared_local[i]);
  if (private_.empty()) return;
  private_load_ = elimination_->solve_private(force(private_, Eigen::all) - reaction(private_local, Eigen::all));
  if (shared_.empty()) return;
  const Affine carried = stiffness(shared_local, private_local) * private_load_;
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= carried.row(static_cast<Eigen::Index>(i));
}

void CondensedOperator::recover(Affine& displacement) const {
  if (private_.empty()) return;
  Affine values = private_load_;
  if (!shared_.empty()) values -= elimination_->transfer() * displacement(shared_, Eigen::all);
  for (std::size_t i = 0; i < private_.size(); ++i) {
    displacement.row(private_[i]) = values.row(static_cast<Eigen::Index>(i));
  }
}

void CondensedOperator::condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const {
  if (private_.empty()) return;
  const Eigen::VectorXd own = weights(private_);
  constant += own.transpose() * private_load_;
  weights(private_).setZero();
  if (!shared_.empty()) weights(shared_) -= (elimination_->transfer().transpose() * own).eval();
}

void CondensedOperator::add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) const {
  const Eigen::VectorXd values = elimination_->stiffness() * displacement(all_);
  force(all_) += values;
}

}  // namespace bempd::coupling

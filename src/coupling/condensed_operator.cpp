#include "coupling/condensed_operator.hpp"

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

CondensedOperator::CondensedOperator(DenseOperator source, const std::vector<DofKind>& kind)
    : stiffness_(std::move(source.stiffness)), symmetric_(source.symmetric) {
  for (std::size_t i = 0; i < source.nodes.size(); ++i) {
    for (int component = 0; component < 2; ++component) {
      const int dof = 2 * source.nodes[i] + component, local = static_cast<int>(2 * i) + component;
      all_.push_back(dof);
      if (kind[dof] == DofKind::private_free) {
        private_.push_back(dof);
        private_local_.push_back(local);
      } else if (kind[dof] == DofKind::shared_free) {
        shared_.push_back(dof);
        shared_local_.push_back(local);
      }
    }
  }
  schur_ = stiffness_(shared_local_, shared_local_);
  if (private_.empty()) return;
  if (symmetric_) {
    eliminate_symmetric();
  } else {
    eliminate_unsymmetric();
  }
}

void CondensedOperator::eliminate_symmetric() {
  cholesky_.compute(stiffness_(private_local_, private_local_));
  if (cholesky_.info() != Eigen::Success) fail_singular();
  if (shared_.empty()) return;
  const Eigen::MatrixXd coupling = stiffness_(private_local_, shared_local_);
  const Eigen::MatrixXd half = cholesky_.matrixL().solve(coupling);
  schur_.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose(), -1.0);
  schur_.triangularView<Eigen::StrictlyUpper>() = schur_.transpose();
  transfer_ = cholesky_.matrixU().solve(half);
}

void CondensedOperator::eliminate_unsymmetric() {
  lu_.compute(stiffness_(private_local_, private_local_));
  if (!(lu_.rcond() > singular_condition)) fail_singular();
  if (shared_.empty()) return;
  transfer_ = lu_.solve(stiffness_(private_local_, shared_local_));
  schur_.noalias() -= stiffness_(shared_local_, private_local_) * transfer_;
}

void CondensedOperator::condense_load(const Affine& force, const Affine& prescribed, Affine& load) {
  const Affine support = prescribed(all_, Eigen::all);
  const Affine reaction = stiffness_ * support;
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= reaction.row(shared_local_[i]);
  if (private_.empty()) return;
  const Affine private_force = force(private_, Eigen::all) - reaction(private_local_, Eigen::all);
  if (symmetric_) {
    private_load_ = cholesky_.solve(private_force);
  } else {
    private_load_ = lu_.solve(private_force);
  }
  if (shared_.empty()) return;
  const Affine carried = stiffness_(shared_local_, private_local_) * private_load_;
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= carried.row(static_cast<Eigen::Index>(i));
}

void CondensedOperator::recover(Affine& displacement) const {
  if (private_.empty()) return;
  Affine values = private_load_;
  if (!shared_.empty()) values -= transfer_ * displacement(shared_, Eigen::all);
  for (std::size_t i = 0; i < private_.size(); ++i) {
    displacement.row(private_[i]) = values.row(static_cast<Eigen::Index>(i));
  }
}

void CondensedOperator::condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const {
  if (private_.empty()) return;
  const Eigen::VectorXd own = weights(private_);
  constant += own.transpose() * private_load_;
  weights(private_).setZero();
  if (!shared_.empty()) weights(shared_) -= (transfer_.transpose() * own).eval();
}

void CondensedOperator::add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) const {
  const Eigen::VectorXd values = stiffness_ * displacement(all_);
  force(all_) += values;
}

}  // namespace bempd::coupling

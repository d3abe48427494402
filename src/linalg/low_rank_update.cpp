#include "linalg/low_rank_update.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

namespace bempd::linalg {

namespace {

class LowRankUpdated final : public SparseFactorization {
 public:
  LowRankUpdated(std::unique_ptr<SparseFactorization> base, int most_columns)
      : base_(std::move(base)), most_columns_(most_columns) {}

  bool factorize(const Eigen::SparseMatrix<double>& matrix) override {
    columns_.resize(matrix.rows(), 0);
    solved_.resize(matrix.rows(), 0);
    signs_.resize(0);
    is_stale_ = false;
    return base_->factorize(matrix);
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    base_->solve_in_place(rhs);
    if (signs_.size() == 0) return;
    const Eigen::MatrixXd pulled = columns_.transpose() * rhs;
    rhs -= solved_ * capacitance_.solve(pulled);
  }

  bool update(const Eigen::SparseMatrix<double>& columns, Change change) override {
    assert(columns.rows() == columns_.rows());
    if (columns.cols() == 0) return !is_stale_;
    // A factor that has missed a change takes no later ones: it would represent no matrix there has been.
    is_stale_ = is_stale_ || signs_.size() + columns.cols() > most_columns_;
    if (is_stale_) return false;
    const Eigen::Index before = signs_.size(), after = before + columns.cols();
    Eigen::MatrixXd solved(columns);
    base_->solve_in_place(solved);
    solved_.conservativeResize(Eigen::NoChange, after);
    solved_.rightCols(columns.cols()) = solved;
    columns_.conservativeResize(columns_.rows(), after);
    columns_.reserve(columns_.nonZeros() + columns.nonZeros());
    columns_.rightCols(columns.cols()) = columns;
    signs_.conservativeResize(after);
    signs_.tail(columns.cols()).setConstant(change == Change::add ? 1.0 : -1.0);
    Eigen::MatrixXd capacitance = columns_.transpose() * solved_;
    capacitance.diagonal() += signs_;
    capacitance_.compute(capacitance);
    return true;
  }

  double smallest_pivot_ratio() const override {
    const double base = base_->smallest_pivot_ratio();
    return signs_.size() == 0 ? base : std::min(base, capacitance_.matrixLU().diagonal().cwiseAbs().minCoeff());
  }

  std::int64_t factor_nonzeros() const override { return base_->factor_nonzeros() + solved_.size(); }

 private:
  std::unique_ptr<SparseFactorization> base_;
  Eigen::Index most_columns_;
  Eigen::SparseMatrix<double> columns_;  // C
  Eigen::MatrixXd solved_;               // Z
  Eigen::VectorXd signs_;                // S
  Eigen::PartialPivLU<Eigen::MatrixXd> capacitance_;
  bool is_stale_ = false;
};

}  // namespace

std::unique_ptr<SparseFactorization> with_low_rank_updates(std::unique_ptr<SparseFactorization> factorization,
                                                           int most_columns) {
  return std::make_unique<LowRankUpdated>(std::move(factorization), most_columns);
}

}  // namespace bempd::linalg

#include "paper/low_rank_update.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

namespace bempd::paper {

namespace {

// Largest number of entries of the stored solutions Z = A^-1 C (with_low_rank_updates()); they take a quarter of a
// gigabyte.
constexpr Eigen::Index most_stored_numbers = Eigen::Index{1} << 25;

using linalg::Change;
using linalg::SparseFactorization;

class LowRankUpdated final : public SparseFactorization {
 public:
  LowRankUpdated(std::unique_ptr<SparseFactorization> base, int most_columns)
      : base_(std::move(base)), most_columns_(most_columns) {}

  bool factorize(const Eigen::SparseMatrix<double>& matrix) override {
    const Eigen::Index rows = std::max<Eigen::Index>(matrix.rows(), 1);
    limit_ = std::min(most_columns_, std::max<Eigen::Index>(most_stored_numbers / rows, 1));
    columns_.resize(matrix.rows(), 0);
    solved_.resize(matrix.rows(), 0);  // update() doubles its memory when needed
    signs_.resize(0);
    capacitance_matrix_.resize(0, 0);
    is_stale_ = false;
    return base_->factorize(matrix);
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    base_->solve_in_place(rhs);
    if (signs_.size() == 0) return;
    const Eigen::MatrixXd pulled = columns_.transpose() * rhs;
    rhs.noalias() -= solved() * capacitance_.solve(pulled);
  }

  bool update(const Eigen::SparseMatrix<double>& columns, Change change) override {
    assert(columns.rows() == columns_.rows());
    if (columns.cols() == 0) return !is_stale_;
    // A factor that has missed one change gets no later changes, because it would then be the factor of no matrix at
    // all.
    is_stale_ = is_stale_ || signs_.size() + columns.cols() > limit_;
    if (is_stale_) return false;
    const Eigen::Index before = signs_.size(), after = before + columns.cols();
    Eigen::MatrixXd solved(columns);
    base_->solve_in_place(solved);
    if (solved_.cols() < after) solved_.conservativeResize(Eigen::NoChange, std::min(limit_, 2 * after));
    solved_.middleCols(before, columns.cols()) = solved;
    columns_.conservativeResize(columns_.rows(), after);
    columns_.reserve(columns_.nonZeros() + columns.nonZeros());
    columns_.rightCols(columns.cols()) = columns;
    signs_.conservativeResize(after);
    signs_.tail(columns.cols()).setConstant(change == Change::add ? 1.0 : -1.0);
    // Only new rows and columns of the capacitance matrix S + C^T Z are computed; old entries stay.
    Eigen::MatrixXd capacitance(after, after);
    capacitance.topLeftCorner(before, before) = capacitance_matrix_;
    capacitance.rightCols(columns.cols()) = columns_.transpose() * solved;
    capacitance.bottomLeftCorner(columns.cols(), before) = columns.transpose() * solved_.leftCols(before);
    capacitance.diagonal().tail(columns.cols()) += signs_.tail(columns.cols());
    capacitance_.compute(capacitance);
    capacitance_matrix_ = std::move(capacitance);
    return true;
  }

  double smallest_pivot_ratio() const override {
    const double base = base_->smallest_pivot_ratio();
    return signs_.size() == 0 ? base : std::min(base, capacitance_.matrixLU().diagonal().cwiseAbs().minCoeff());
  }

  std::int64_t factor_nonzeros() const override { return base_->factor_nonzeros() + solved().size(); }

 private:
  Eigen::Block<const Eigen::MatrixXd, Eigen::Dynamic, Eigen::Dynamic, true> solved() const {
    return solved_.leftCols(signs_.size());
  }

  std::unique_ptr<SparseFactorization> base_;
  Eigen::Index most_columns_, limit_ = 0;
  Eigen::SparseMatrix<double> columns_;  // C
  Eigen::MatrixXd solved_;               // Z, with room for more columns
  Eigen::MatrixXd capacitance_matrix_;   // S + C^T Z
  Eigen::VectorXd signs_;                // S
  Eigen::PartialPivLU<Eigen::MatrixXd> capacitance_;
  bool is_stale_ = false;
};

}  // namespace

std::unique_ptr<SparseFactorization> with_low_rank_updates(std::unique_ptr<SparseFactorization> factorization,
                                                           int most_columns) {
  return std::make_unique<LowRankUpdated>(std::move(factorization), most_columns);
}

}  // namespace bempd::paper

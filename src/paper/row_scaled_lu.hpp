#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "linalg/sparse_factorization.hpp"

namespace bempd::paper {

// Factorization for make_sparse_lu() by one of Eigen's solvers, with scaled rows. `Solver` must also have pivots()
// (U_jj by column of the matrix) and entries(), and throw on failures that are not due to the matrix.
template <class Solver>
class RowScaledLU final : public linalg::SparseFactorization {
 public:
  bool factorize(const Eigen::SparseMatrix<double>& matrix) override {
    assert(matrix.rows() == matrix.cols());
    has_factor_ = false;
    size_ = matrix.rows();
    if (size_ == 0) return has_factor_ = true;
    Matrix scaled = matrix;
    if (!scaled.coeffs().allFinite() || !scale(scaled)) return false;
    const bool analysed = is_analysed_ && same_pattern(scaled, scaled_);
    scaled_ = std::move(scaled);
    is_analysed_ = analysed;  // an exception on the way must not leave a matrix without its analysis
    if (!analysed) {
      solver_.analyzePattern(scaled_);
      is_analysed_ = true;
    }
    solver_.factorize(scaled_);
    return has_factor_ = solver_.info() == Eigen::Success && smallest_pivot_ratio() > linalg::singular_pivot_ratio;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == size_);
    if (rhs.size() == 0) return;
    rhs.array().colwise() /= row_scale_;
    rhs = solver_.solve(rhs).eval();
  }

  bool update(const Eigen::SparseMatrix<double>& columns, linalg::Change) override {
    assert(has_factor_ && columns.rows() == size_);
    return columns.nonZeros() == 0;
  }

  double smallest_pivot_ratio() const override {
    if (size_ == 0) return 1;
    const Eigen::ArrayXd ratio = solver_.pivots().array().abs() / column_scale_;
    return ratio.minCoeff<Eigen::PropagateNaN>();
  }

  std::int64_t factor_nonzeros() const override { return size_ == 0 ? 0 : solver_.entries(); }

 private:
  using Matrix = typename Solver::MatrixType;

  // Divides every row by its largest entry; false if a row is zero.
  bool scale(Matrix& matrix) {
    row_scale_.setZero(size_);
    column_scale_.setZero(size_);
    const auto for_each_entry = [&](const auto& visit) {
      for (Eigen::Index j = 0; j < size_; ++j)
        for (typename Matrix::InnerIterator it(matrix, j); it; ++it) visit(it);
    };
    for_each_entry([&](auto& it) { row_scale_[it.row()] = std::max(row_scale_[it.row()], std::abs(it.value())); });
    if (row_scale_.minCoeff() == 0) return false;
    for_each_entry([&](auto& it) {
      it.valueRef() /= row_scale_[it.row()];
      column_scale_[it.col()] = std::max(column_scale_[it.col()], std::abs(it.value()));
    });
    return true;
  }

  static bool same_pattern(const Matrix& a, const Matrix& b) {
    return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols(), b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
  }

  Matrix scaled_;  // matrix that was analysed or factorized; `solver_` may refer to it
  Solver solver_;
  Eigen::Index size_ = 0;
  Eigen::ArrayXd row_scale_, column_scale_;
  bool is_analysed_ = false, has_factor_ = false;
};

}  // namespace bempd::paper

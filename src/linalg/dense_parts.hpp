#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "cancellation.hpp"

namespace bempd::linalg {

// Dense algebra that can be cancelled: long operations are done in parts, with a check for cancellation between them.
// Short operations are a single call of Eigen.

// Number of floating-point operations in one part, which takes some 30 ms.
constexpr double operations_at_once = 5e8;

inline bool is_long(double operations) { return operations > operations_at_once; }

// Matrix in memory, or the transpose of a matrix in memory. Products are compiled for these two cases only, because
// each further type takes seconds to compile.
class Operand {
 public:
  template <class Derived>
  Operand(const Eigen::MatrixBase<Derived>& matrix)
      : data_(matrix.derived().data()),
        rows_(matrix.rows()),
        cols_(matrix.cols()),
        stride_(matrix.derived().outerStride()),
        is_transposed_(Derived::IsRowMajor) {
    static_assert(Derived::InnerStrideAtCompileTime == 1 && !Derived::IsVectorAtCompileTime);
  }

  Eigen::Index cols() const { return cols_; }
  Operand middle_rows(Eigen::Index first, Eigen::Index count) const {
    return {data_ + first * (is_transposed_ ? stride_ : 1), count, cols_, stride_, is_transposed_};
  }
  Operand transpose() const { return {data_, cols_, rows_, stride_, !is_transposed_}; }

  // Calls visit(matrix) with the matrix or its transpose as an Eigen expression.
  template <class Visit>
  void as_matrix(const Visit& visit) const {
    using Stored = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
    if (is_transposed_) {
      visit(Stored(data_, cols_, rows_, Eigen::OuterStride<>(stride_)).transpose());
    } else {
      visit(Stored(data_, rows_, cols_, Eigen::OuterStride<>(stride_)));
    }
  }

 private:
  Operand(const double* data, Eigen::Index rows, Eigen::Index cols, Eigen::Index stride, bool is_transposed)
      : data_(data), rows_(rows), cols_(cols), stride_(stride), is_transposed_(is_transposed) {}

  const double* data_;
  Eigen::Index rows_, cols_, stride_;
  bool is_transposed_;
};

// Computes c += factor * a * b.
void add_product(Eigen::Ref<Eigen::MatrixXd> c, const Operand& a, const Operand& b, double factor = 1);

// Computes c += factor * a * a^T, the lower triangle only.
void add_square(Eigen::Ref<Eigen::MatrixXd> c, const Operand& a, double factor = 1);

// Solution with the lower triangle L of a matrix: x <- L^-1 x.
void solve_lower(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);
void solve_upper(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);  // x <- L^-T x
// Solution x <- x L^-T with the lower triangle L of a matrix.
void solve_upper_from_right(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);

// Replaces the lower triangle of a symmetric matrix by its Cholesky factor; false if the matrix is not positive
// definite.
bool factorize_in_parts(Eigen::Ref<Eigen::MatrixXd> lower);

// Cholesky factor of a symmetric positive definite matrix, of which only the lower triangle is read.
class DenseCholesky : public Eigen::LLT<Eigen::MatrixXd> {
 public:
  void compute(Eigen::MatrixXd matrix);
  const Eigen::MatrixXd& lower() const { return m_matrix; }  // the upper triangle has arbitrary values
};

// LU factors of any matrix, with partial pivoting.
class DenseLU : public Eigen::PartialPivLU<Eigen::MatrixXd> {
 public:
  void compute(Eigen::MatrixXd matrix);
};

// Solution factor^-1 x, computed for a few columns of x at a time so that it can be cancelled.
template <class Factor>
Eigen::MatrixXd solve_in_parts(const Factor& factor, Eigen::MatrixXd x) {
  const double each = 2 * static_cast<double>(factor.rows()) * static_cast<double>(factor.rows());
  if (!is_long(each * static_cast<double>(x.cols()))) return factor.solve(x);
  const Eigen::Index at_once = std::max<Eigen::Index>(16, static_cast<Eigen::Index>(operations_at_once / each));
  for (Eigen::Index j = 0; j < x.cols(); j += at_once) {
    check_cancelled();
    auto part = x.middleCols(j, std::min(at_once, x.cols() - j));
    part = factor.solve(part).eval();
  }
  return x;
}

}  // namespace bempd::linalg

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "cancellation.hpp"

namespace bempd::linalg {

// Dense algebra that hears a request to stop: what takes long is done in parts. What does not is one call, as it would
// be without this.

// Floating point operations in a part: some 30 ms.
constexpr double operations_at_once = 5e8;

inline bool is_long(double operations) { return operations > operations_at_once; }

// c += factor * a * b.
template <class A, class B>
void add_product(Eigen::Ref<Eigen::MatrixXd> c, const A& a, const B& b, double factor = 1) {
  const double inner = 2.0 * static_cast<double>(a.cols());
  if (!is_long(inner * static_cast<double>(c.size()))) {
    c.noalias() += factor * (a * b);
    return;
  }
  constexpr Eigen::Index width = 512;
  const Eigen::Index height = std::max<Eigen::Index>(64, static_cast<Eigen::Index>(operations_at_once / inner) / width);
  for (Eigen::Index j = 0; j < c.cols(); j += width) {
    const Eigen::Index columns = std::min(width, c.cols() - j);
    for (Eigen::Index i = 0; i < c.rows(); i += height) {
      const Eigen::Index rows = std::min(height, c.rows() - i);
      check_cancelled();
      c.block(i, j, rows, columns).noalias() += factor * (a.middleRows(i, rows) * b.middleCols(j, columns));
    }
  }
}

// The lower triangle of c += factor * a * a^T.
template <class A>
void add_square(Eigen::Ref<Eigen::MatrixXd> c, const A& a, double factor = 1) {
  const auto n = static_cast<double>(c.rows());
  if (!is_long(n * n * static_cast<double>(a.cols()))) {
    c.selfadjointView<Eigen::Lower>().rankUpdate(a, factor);
    return;
  }
  constexpr Eigen::Index width = 256;
  for (Eigen::Index j = 0; j < c.rows(); j += width) {
    const Eigen::Index columns = std::min(width, c.rows() - j), below = c.rows() - j - columns;
    check_cancelled();
    c.block(j, j, columns, columns)
        .template selfadjointView<Eigen::Lower>()
        .rankUpdate(a.middleRows(j, columns), factor);
    add_product(c.bottomRows(below).middleCols(j, columns), a.bottomRows(below), a.middleRows(j, columns).transpose(),
                factor);
  }
}

// x <- L^-1 x, x <- L^-T x and x <- x L^-T, of the lower triangle of a matrix.
void solve_lower(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);
void solve_upper(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);
void solve_upper_from_right(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> x);

// Replaces the lower triangle by its Cholesky factor; false if it is not positive definite.
bool factorize_in_parts(Eigen::Ref<Eigen::MatrixXd> lower);

// Cholesky factor of a symmetric positive definite matrix, of which only the lower triangle counts.
class DenseCholesky : public Eigen::LLT<Eigen::MatrixXd> {
 public:
  void compute(Eigen::MatrixXd matrix);
  const Eigen::MatrixXd& lower() const { return m_matrix; }  // its other triangle is anything
};

// Of any matrix, with partial pivoting.
class DenseLU : public Eigen::PartialPivLU<Eigen::MatrixXd> {
 public:
  void compute(Eigen::MatrixXd matrix);
};

// factor^-1 x, some right-hand sides after the other.
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

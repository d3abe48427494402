#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>

#include "linalg/krylov.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::coupling {

// Sparse direct factor and the iteration that it preconditions: one application of a factor of the present matrix is a
// solution; a stale factor takes more.
class SystemSolver {
 public:
  using Apply = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&)>;  // (x, y): y = A x

  virtual ~SystemSolver() = default;

  virtual linalg::SparseFactorization& factorization() = 0;

  // Cholesky factorization, where the matrix is symmetric and its unknowns can be ordered and condensed; null if not.
  virtual linalg::SparseCholesky* cholesky() { return nullptr; }

  // Improves `x` until the residual has at most this inf-norm relative to the right-hand side, or gives up.
  virtual linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                                       Eigen::VectorXd& x) const = 0;

  // Product A x with an assembled matrix.
  virtual Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const = 0;
};

}  // namespace bempd::coupling

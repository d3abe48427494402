#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>

#include "linalg/krylov.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::coupling {

// Sparse direct factor and an iteration that it preconditions. The iteration takes one step with a factor of the
// present matrix, and more steps with a stale factor.
class SystemSolver {
 public:
  using Apply = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&)>;  // (x, y): y = A x

  virtual ~SystemSolver() = default;

  virtual linalg::SparseFactorization& factorization() = 0;

  // Cholesky factorization if the matrix is symmetric, so that its unknowns can be ordered and condensed; else null.
  virtual linalg::SparseCholesky* cholesky() { return nullptr; }

  // Improves `x` until the largest residual is at most `tolerance` times the largest entry of `rhs`, or gives up.
  virtual linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                                       Eigen::VectorXd& x) const = 0;

  // Product A x with an assembled matrix.
  virtual Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const = 0;
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linalg/up_looking_ldlt.hpp"

namespace bempd::linalg {

// Shortest x = B^T lambda with B x = r for a consistent right-hand side, by conjugate gradients on N lambda = r, N = B
// B^T. N is singular, so the Cholesky factor F of the slightly shifted matrix serves as preconditioner, in the form
// F^-1 N F^-1: F^-1 alone would amplify the kernel's share of the rounding in r by the inverse of the shift and drown
// the rest.
class SparseMinimumNorm {
 public:
  // `shift` of N, over its largest entry: eigenvalues below it take many steps; a shift near rounding may leave nothing
  // positive to factorize, and is then raised.
  explicit SparseMinimumNorm(double shift) : shift_(shift) {}

  // Factorizes N of a matrix B; matrices that follow each other have the same pattern. Can be cancelled.
  void factorize(const Eigen::SparseMatrix<double>& b);

  struct Step {
    Eigen::VectorXd lambda, change;  // change = B^T lambda
  };
  // Solves to a residual of 1e-5 of r, or half of `least_residual`.
  Step solve(Eigen::VectorXd r, double least_residual) const;

 private:
  Eigen::VectorXd precondition(const Eigen::VectorXd& r) const;
  Eigen::VectorXd apply_inverse(const Eigen::VectorXd& r) const;  // F^-1 r

  double shift_;
  Eigen::SparseMatrix<double> b_, bt_;
  UpLookingLDLT factor_;
  std::vector<int> order_;  // of elimination; empty: no pattern yet
};

}  // namespace bempd::linalg

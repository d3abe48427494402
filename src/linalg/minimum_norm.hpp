#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linalg/up_looking_ldlt.hpp"

namespace bempd::linalg {

// Solver for the shortest x = B^T lambda with B x = r, by conjugate gradients on N lambda = r with N = B B^T; r must be
// such that there is a solution. N is singular, so the Cholesky factor F of a slightly shifted N serves as
// preconditioner, in the form F^-1 N F^-1. F^-1 alone would amplify rounding errors of r in the kernel of N by the
// inverse of the shift, until they exceed all else.
class SparseMinimumNorm {
 public:
  // Prepares the solver with a shift of N's diagonal, given as a multiple of its largest entry. Eigenvalues below the
  // shift take many steps. With a shift near rounding the matrix may not be positive definite; the shift is then
  // raised.
  explicit SparseMinimumNorm(double shift) : shift_(shift) {}

  // Factorizes N = B B^T for the matrix B. All matrices given to one object must have the same pattern. Can be
  // cancelled.
  void factorize(const Eigen::SparseMatrix<double>& b);

  struct Step {
    Eigen::VectorXd lambda, change;  // change = B^T lambda
  };
  // Solves N lambda = B B^T lambda = r until the residual is at most the larger of 1e-5 times the largest entry of r
  // and half of `least_residual`.
  Step solve(Eigen::VectorXd r, double least_residual) const;

 private:
  Eigen::VectorXd precondition(const Eigen::VectorXd& r) const;
  Eigen::VectorXd apply_inverse(const Eigen::VectorXd& r) const;  // F^-1 r

  double shift_;
  Eigen::SparseMatrix<double> b_, bt_;
  UpLookingLDLT factor_;
  std::vector<int> order_;  // order of elimination; empty: no pattern yet
};

}  // namespace bempd::linalg

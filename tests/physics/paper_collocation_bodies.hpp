#pragma once

#include "physics/bem_bodies.hpp"

// What the tests of the collocation operator share beyond the bodies: its stiffness is not symmetric.
namespace bempd::bem_test {

// Solves K u = f with the given values where `fixed`.
inline Eigen::VectorXd solve_unsymmetric(const Eigen::MatrixXd& k, const Eigen::VectorXd& f,
                                         const std::vector<bool>& fixed, const Eigen::VectorXd& values) {
  Eigen::MatrixXd matrix = k;
  Eigen::VectorXd right = f;
  const double diagonal = k.diagonal().maxCoeff();
  for (int i = 0; i < f.size(); ++i) {
    if (!fixed[i]) continue;
    matrix.row(i).setZero();
    matrix(i, i) = diagonal;
    right[i] = diagonal * values[i];
  }
  return dense::solve(matrix, right);
}

// |K - K^T| / |K|, Frobenius.
inline double asymmetry(const Eigen::MatrixXd& k) { return (k - k.transpose()).norm() / k.norm(); }

}  // namespace bempd::bem_test

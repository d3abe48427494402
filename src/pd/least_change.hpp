#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace bempd::pd {

// Stiffnesses k that satisfy A k = b and stay as close as possible to given ones:
//   minimise sum ((k - start) / scale)^2   subject to   A k = b,   k >= lower * scale.
struct LeastChange {
  Eigen::SparseMatrix<double> constraints;  // A; rows may depend on each other as long as they do not contradict
  Eigen::VectorXd target;                   // b
  Eigen::VectorXd start, scale;
  double lower = 0;  // bound on k / scale
};

struct LeastChangeResult {
  Eigen::VectorXd stiffness;
  double residual = 0;      // largest |A k - b|
  int conjugate_steps = 0;  // over all solves
  int bounded = 0;          // bonds that the bound holds
};

LeastChangeResult solve_least_change(const LeastChange& problem);

}  // namespace bempd::pd

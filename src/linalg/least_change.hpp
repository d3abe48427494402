#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace bempd::linalg {

// Values x that satisfy A x = b and stay as close as possible to given ones:
//   minimise sum ((x - start) / scale)^2   subject to   A x = b,   x >= lower * scale.
struct LeastChange {
  Eigen::SparseMatrix<double> constraints;  // A; rows may depend on each other as long as they do not contradict
  Eigen::VectorXd target;                   // b
  Eigen::VectorXd start, scale;
  double lower = 0;  // bound on x / scale
};

struct LeastChangeResult {
  Eigen::VectorXd values;
  double residual = 0;  // largest |A x - b|
};

LeastChangeResult solve_least_change(const LeastChange& problem);

// Solves the same problem where the equations lie along a line hundreds of times longer than the reach of each.
// Solutions that vary slowly along the line then have eigenvalues near rounding.
LeastChangeResult solve_long_least_change(const LeastChange& problem);

}  // namespace bempd::linalg

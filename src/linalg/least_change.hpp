#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace bempd::linalg {

// Values x that satisfy A x = b and stay as close as possible to given values `start`:
//   minimise sum ((x - start) / scale)^2   subject to   A x = b,   x >= lower * scale.
struct LeastChange {
  Eigen::SparseMatrix<double> constraints;  // A; rows may be dependent but not contradictory
  Eigen::VectorXd target;                   // b
  Eigen::VectorXd start, scale;
  double lower = 0;  // bound on x / scale
};

struct LeastChangeResult {
  Eigen::VectorXd values;
  double residual = 0;  // largest |A x - b|
};

LeastChangeResult solve_least_change(const LeastChange& problem);

// Solves the problem for equations in a row (along an edge, for instance) that is hundreds of times longer than the
// reach of one equation. Solutions that vary slowly along the row then belong to eigenvalues near the rounding error.
LeastChangeResult solve_long_least_change(const LeastChange& problem);

}  // namespace bempd::linalg

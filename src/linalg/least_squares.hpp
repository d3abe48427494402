#pragma once

#include <Eigen/Core>
#include <memory>

namespace bempd::linalg {

// Solves dense equations in the sense of least squares by a complete orthogonal decomposition; of several solutions it
// takes the shortest. There is one size for all, as each takes seconds to compile.
class LeastSquares {
 public:
  explicit LeastSquares(const Eigen::MatrixXd& equations);
  // Decomposes the matrix; pivots below the threshold, relative to the largest one, count as zero.
  LeastSquares(const Eigen::MatrixXd& equations, double threshold);
  ~LeastSquares();

  Eigen::MatrixXd solve(const Eigen::MatrixXd& wanted) const;

 private:
  struct Decomposition;
  std::unique_ptr<Decomposition> own_;
};

}  // namespace bempd::linalg

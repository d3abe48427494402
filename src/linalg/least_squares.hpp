#pragma once

#include <Eigen/Core>
#include <memory>

namespace bempd::linalg {

// Least-squares solver of dense equations, by a complete orthogonal decomposition; if there are several solutions, it
// returns the shortest. Eigen's class is compiled for one (dynamic) size only, because each size takes seconds.
class LeastSquares {
 public:
  explicit LeastSquares(const Eigen::MatrixXd& equations);
  // Decomposes the matrix; pivots whose ratio to the largest pivot is below `threshold` count as zero.
  LeastSquares(const Eigen::MatrixXd& equations, double threshold);
  ~LeastSquares();

  Eigen::MatrixXd solve(const Eigen::MatrixXd& wanted) const;

 private:
  struct Decomposition;
  std::unique_ptr<Decomposition> own_;
};

}  // namespace bempd::linalg

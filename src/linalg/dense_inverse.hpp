#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

// In place, on lower triangles: L <- L^-1, and L <- the lower triangle of L^T L. By halves, so that products of large
// blocks do the work.
void invert_lower(Eigen::Ref<Eigen::MatrixXd> lower);
void multiply_by_transpose(Eigen::Ref<Eigen::MatrixXd> lower);

// (L L^T)^-1, its lower triangle, in place of L.
inline void invert_from_cholesky(Eigen::Ref<Eigen::MatrixXd> lower) {
  invert_lower(lower);
  multiply_by_transpose(lower);
}

}  // namespace bempd::linalg

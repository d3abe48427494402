#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

// In-place operations on lower triangles: L <- L^-1, and L <- the lower triangle of L^T L. They work by halves, so that
// most of the work is products of large blocks.
void invert_lower(Eigen::Ref<Eigen::MatrixXd> lower);
void multiply_by_transpose(Eigen::Ref<Eigen::MatrixXd> lower);

// Replaces L by the lower triangle of (L L^T)^-1.
inline void invert_from_cholesky(Eigen::Ref<Eigen::MatrixXd> lower) {
  invert_lower(lower);
  multiply_by_transpose(lower);
}

}  // namespace bempd::linalg

#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

// Inverse of a lower triangle in place: L <- L^-1. It works by halves, so that most of the work is products of large
// blocks.
void invert_lower(Eigen::Ref<Eigen::MatrixXd> lower);
// Product of a lower triangle with its transpose in place: L <- the lower triangle of L^T L, computed by halves.
void multiply_by_transpose(Eigen::Ref<Eigen::MatrixXd> lower);

// Replaces L by the lower triangle of (L L^T)^-1.
inline void invert_from_cholesky(Eigen::Ref<Eigen::MatrixXd> lower) {
  invert_lower(lower);
  multiply_by_transpose(lower);
}

}  // namespace bempd::linalg

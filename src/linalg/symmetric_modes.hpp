#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

// Eigenvalues of a symmetric matrix in ascending order, with orthonormal eigenvectors as columns.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// Computes eigenvalues and eigenvectors from the lower triangle. Eigen's class is compiled for one (dynamic) size only,
// because each size takes seconds.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

}  // namespace bempd::linalg

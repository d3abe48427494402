#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

// Eigenvalues of a symmetric matrix in rising order, with orthonormal eigenvectors as columns.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// Computes the modes from the lower triangle. There is one size for all, as each takes seconds to compile.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

}  // namespace bempd::linalg

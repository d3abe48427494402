#include "linalg/symmetric_modes.hpp"

#include <Eigen/Eigenvalues>

namespace bempd::linalg {

SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace bempd::linalg

#pragma once

#include <Eigen/Core>

// Eigen's decompositions for the tests, compiled once.
namespace bempd::dense {

// X in A X = B, by LU with partial pivoting.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// Eigenvalues of a symmetric matrix, in rising order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& matrix);

// X with least |A X - B|, for A of full rank.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace bempd::dense

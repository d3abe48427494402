#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace bempd::linalg {

// Largest entry of every row, by magnitude.
inline Eigen::VectorXd largest_in_rows(const Eigen::SparseMatrix<double>& matrix) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(matrix.rows());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      largest[it.row()] = std::max(largest[it.row()], std::abs(it.value()));
  return largest;
}

// Largest entry of every column once the rows have been divided by `row_scale` (all positive).
inline Eigen::VectorXd largest_in_columns(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& row_scale) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(matrix.cols());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      largest[j] = std::max(largest[j], std::abs(it.value()) / row_scale[it.row()]);
  return largest;
}

}  // namespace bempd::linalg

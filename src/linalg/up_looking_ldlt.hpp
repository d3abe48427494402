#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace bempd::linalg {

// Order of elimination with little fill for a symmetric matrix, given by its lower triangle: entry k is the unknown
// that is eliminated as the k-th.
std::vector<int> minimum_degree(const Eigen::SparseMatrix<double>& lower);
// Upper triangle of a symmetric matrix, given by its lower triangle, in an order of elimination; columns are not
// sorted.
Eigen::SparseMatrix<double> upper_in_order(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order);

// Factors A = L D L^T of a sparse symmetric matrix, computed row by row of L in the order of elimination (T. A. Davis,
// ACM Trans. Math. Software 31, 2005, algorithm 849). Eigen's own method can neither be cancelled nor report its
// progress.
class UpLookingLDLT {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  // Finds the pattern of L from the upper triangle of A. Sums are computed in the order of the entries in the
  // triangle's columns.
  void analyse(const Matrix& upper);
  // Computes the values of L and D for the analysed pattern; false if a pivot is 0. Can be cancelled.
  bool factorize(const Matrix& upper);

  const Matrix& unit_lower() const { return unit_lower_; }  // without its diagonal of ones
  const Eigen::VectorXd& pivots() const { return pivots_; }

  void solve_forward(Eigen::Ref<Eigen::MatrixXd> x) const;   // x <- L^-1 x
  void solve_backward(Eigen::Ref<Eigen::MatrixXd> x) const;  // x <- L^-T x

 private:
  // Finds the columns of L that have an entry in row k, from the columns of the upper triangle. In the list, a column
  // comes after all columns on which it depends.
  int pattern_of_row(const Matrix& upper, int k);

  Matrix unit_lower_;
  Eigen::VectorXd pivots_;
  std::vector<int> parent_;  // row of the first entry below the diagonal in each column of L; -1: none
  std::vector<int> length_;  // present number of entries in each column of L
  std::vector<int> seen_, pattern_;
};

}  // namespace bempd::linalg

#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace bempd::linalg {

// An order of elimination with little fill for a symmetric matrix, of which the lower triangle is given: what is
// eliminated k-th.
std::vector<int> minimum_degree(const Eigen::SparseMatrix<double>& lower);
// The upper triangle in that order. Its columns are not sorted.
Eigen::SparseMatrix<double> upper_in_order(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order);

// A = L D L^T of a sparse symmetric matrix, row after row of L, the order of elimination being that of the rows (T. A.
// Davis, ACM Trans. Math. Software 31, 2005, algorithm 849). Eigen's own can neither be stopped nor say how far it is.
class UpLookingLDLT {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  // Where entries of L will be, from the upper triangle. The order of the entries in its columns decides in which one
  // sums are formed.
  void analyse(const Matrix& upper);
  // Numbers for the pattern that was analysed; false if a pivot is 0. Hears requests to stop.
  bool factorize(const Matrix& upper);

  const Matrix& unit_lower() const { return unit_lower_; }  // without its diagonal of ones
  const Eigen::VectorXd& pivots() const { return pivots_; }

  void solve_forward(Eigen::Ref<Eigen::MatrixXd> x) const;   // x <- L^-1 x
  void solve_backward(Eigen::Ref<Eigen::MatrixXd> x) const;  // x <- L^-T x

 private:
  // Columns that have an entry in row k, each after those that it depends on, from the columns of the upper triangle.
  int pattern_of_row(const Matrix& upper, int k);

  Matrix unit_lower_;
  Eigen::VectorXd pivots_;
  std::vector<int> parent_;  // the first entry below the diagonal in a column of L; -1: there is none
  std::vector<int> length_;  // of the columns of L as far as they are known
  std::vector<int> seen_, pattern_;
};

}  // namespace bempd::linalg

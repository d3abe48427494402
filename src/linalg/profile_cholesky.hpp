#pragma once

#include <Eigen/Core>
#include <vector>

namespace bempd::linalg {

// Cholesky factor of a symmetric positive definite matrix whose entries lie close to the diagonal. Each row is stored
// from its first entry to the diagonal, in dense panels of rows. Unknowns come in groups of four.
class ProfileCholesky {
 public:
  static constexpr int group = 4;

  // Prepares storage. `first_coupled` has for each group the first group that it is coupled to (itself, or an earlier
  // one).
  explicit ProfileCholesky(const std::vector<int>& first_coupled);

  void clear();
  // Block of the matrix with the rows of group `row` and the columns of group `column` <= row. All 16 entries of
  // diagonal blocks must be set.
  Eigen::Block<Eigen::MatrixXd, group, group> at(int row, int column);
  double largest_diagonal() const;
  // Factorizes the matrix plus `shift` on its diagonal; false if the sum is not positive definite.
  bool factorize(double shift);

  void solve_in_place(Eigen::Ref<Eigen::VectorXd> x) const;

 private:
  static constexpr int groups = 6, rows = group * groups;  // groups and rows of a panel

  Eigen::Index column_of(std::size_t panel, std::size_t of) const {
    return static_cast<Eigen::Index>(of - first_[panel]) * rows;
  }

  int size_;
  std::vector<std::size_t> first_;       // per panel: the first panel that it is coupled to
  std::vector<Eigen::MatrixXd> panels_;  // per panel: blocks with panels first_[panel] .. panel
};

// Order of nodes in which coupled nodes are near each other (Cuthill and McKee 1969), one connected part after the
// other. The neighbours of node n are `neighbours` from start[n] to start[n + 1].
std::vector<int> close_order(const std::vector<int>& start, const std::vector<int>& neighbours);

}  // namespace bempd::linalg

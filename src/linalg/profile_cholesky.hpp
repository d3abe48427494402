#pragma once

#include <Eigen/Core>
#include <vector>

namespace bempd::linalg {

// Cholesky factor of a symmetric positive definite matrix whose entries lie close to the diagonal: row after row from
// the first entry of each, in dense panels of rows. For unknowns in groups of four.
class ProfileCholesky {
 public:
  static constexpr int group = 4;

  // By the first group that each group is coupled to, itself at the latest.
  explicit ProfileCholesky(const std::vector<int>& first_coupled);

  void clear();
  // Where rows of the group `row` meet columns of the group `column` <= row. Of those on the diagonal all 16.
  Eigen::Block<Eigen::MatrixXd, group, group> at(int row, int column);
  double largest_diagonal() const;
  // Of the matrix plus `shift` on its diagonal; false if that is not positive definite.
  bool factorize(double shift);

  void solve_in_place(Eigen::Ref<Eigen::VectorXd> x) const;

 private:
  static constexpr int groups = 6, rows = group * groups;  // of a panel

  Eigen::Index column_of(std::size_t panel, std::size_t of) const {
    return static_cast<Eigen::Index>(of - first_[panel]) * rows;
  }

  int size_;
  std::vector<std::size_t> first_;       // per panel, the first that it is coupled to
  std::vector<Eigen::MatrixXd> panels_;  // from that up to itself
};

// An order of nodes by which coupled ones come close to each other (Cuthill and McKee 1969), part after part of what
// hangs together. `neighbours` of nodes by compressed rows.
std::vector<int> close_order(const std::vector<int>& start, const std::vector<int>& neighbours);

}  // namespace bempd::linalg

#include "linalg/supernodal_factor.hpp"

#include <algorithm>
#include <cassert>

namespace bempd::linalg {

SupernodalFactor::SupernodalFactor(const cholmod_factor& factor)
    : supernodes_(static_cast<std::ptrdiff_t>(factor.nsuper)),
      size_(static_cast<int>(factor.n)),
      values_(static_cast<const double*>(factor.x)),
      first_column_(static_cast<const int*>(factor.super)),
      rows_begin_(static_cast<const int*>(factor.pi)),
      values_begin_(static_cast<const int*>(factor.px)),
      row_(static_cast<const int*>(factor.s)) {
  assert(factor.is_super);
}

Eigen::MatrixXd SupernodalFactor::trailing_block(int size) const {
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
  const int first = size_ - size;
  for (std::ptrdiff_t s = 0; s < supernodes_; ++s) {
    const int rows = rows_begin_[s + 1] - rows_begin_[s];
    for (int j = std::max(first_column_[s], first); j < first_column_[s + 1]; ++j) {
      const int k = j - first_column_[s];
      const double* column = values_ + values_begin_[s] + static_cast<std::ptrdiff_t>(k) * rows;
      for (int r = k; r < rows; ++r) block(row_[rows_begin_[s] + r] - first, j - first) = column[r];
    }
  }
  return block;
}

void SupernodalFactor::solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const {
  const int unknown = size_ - known;
  Eigen::MatrixXd later;  // what a supernode's columns depend on
  for (std::ptrdiff_t s = supernodes_ - 1; s >= 0; --s) {
    const int columns = std::min(first_column_[s + 1], unknown) - first_column_[s];
    if (columns <= 0) continue;
    const int rows = rows_begin_[s + 1] - rows_begin_[s];
    const Eigen::Map<const Eigen::MatrixXd> panel(values_ + values_begin_[s], rows, columns);
    auto own = transposed.middleCols(first_column_[s], columns);
    later.resize(transposed.rows(), rows - columns);
    for (int r = columns; r < rows; ++r) later.col(r - columns) = transposed.col(row_[rows_begin_[s] + r]);
    if (rows > columns) own.noalias() -= later * panel.bottomRows(rows - columns);
    panel.topRows(columns).triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(own);
  }
}

}  // namespace bempd::linalg

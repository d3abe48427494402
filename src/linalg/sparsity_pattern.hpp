#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <vector>

namespace bempd::linalg {

// Sparsity pattern of a compressed matrix, stored to tell whether an analysis is still valid for a matrix.
template <class Index>
class SparsityPattern {
 public:
  void assign(const Eigen::SparseMatrix<double>& matrix) {
    assert(matrix.isCompressed());
    rows_.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
    start_.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1);
  }
  void clear() { start_.clear(); }

  // Whether the matrix has the stored pattern; always false after clear().
  bool matches(const Eigen::SparseMatrix<double>& matrix) const {
    assert(matrix.isCompressed());
    return start_.size() == static_cast<std::size_t>(matrix.cols() + 1) &&
           std::equal(start_.begin(), start_.end(), matrix.outerIndexPtr()) &&
           std::equal(rows_.begin(), rows_.end(), matrix.innerIndexPtr());
  }

  // Stored pattern in compressed columns: column j has the entries of rows() from column_start()[j] to column_start()[j
  // + 1].
  const std::vector<Index>& column_start() const { return start_; }
  const std::vector<Index>& rows() const { return rows_; }

 private:
  std::vector<Index> start_, rows_;
};

}  // namespace bempd::linalg

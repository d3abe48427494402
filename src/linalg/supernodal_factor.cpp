#include "linalg/supernodal_factor.hpp"

#include <algorithm>
#include <cassert>

#include "cancellation.hpp"

namespace bempd::linalg {

template <class Index>
SupernodalFactor<Index>::SupernodalFactor(const cholmod_factor& factor)
    : supernodes_(static_cast<std::ptrdiff_t>(factor.nsuper)),
      size_(static_cast<int>(factor.n)),
      values_(static_cast<const double*>(factor.x)),
      first_column_(static_cast<const Index*>(factor.super)),
      rows_begin_(static_cast<const Index*>(factor.pi)),
      values_begin_(static_cast<const Index*>(factor.px)),
      row_(static_cast<const Index*>(factor.s)),
      most_rows_below_(static_cast<Eigen::Index>(std::max<std::size_t>(factor.maxesize, 1))) {
  assert(factor.is_super);
}

template <class Index>
Eigen::MatrixXd SupernodalFactor<Index>::trailing_block(int size) const {
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
  const int first = size_ - size;
  for (std::ptrdiff_t s = 0; s < supernodes_; ++s) {
    const int rows = rows_of(s), begin = static_cast<int>(first_column_[s]), end = begin + columns_of(s);
    for (int j = std::max(begin, first); j < end; ++j) {
      const int k = j - begin;
      const double* column = values_ + values_begin_[s] + static_cast<std::ptrdiff_t>(k) * rows;
      for (int r = k; r < rows; ++r) block(row_[rows_begin_[s] + r] - first, j - first) = column[r];
    }
  }
  return block;
}

// Gathers the entries of all right-hand sides in the rows below the triangle of supernode `s`.
template <class Index>
void SupernodalFactor<Index>::gather(std::ptrdiff_t s, const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const int columns = columns_of(s), below = rows_of(s) - columns;
  const Index* const row = row_ + rows_begin_[s] + columns;
  for (Eigen::Index c = 0; c < x.cols(); ++c)
    for (int r = 0; r < below; ++r) below_(r, c) = x(row[r], c);
}

template <class Index>
void SupernodalFactor<Index>::solve_lower(Eigen::Ref<Eigen::MatrixXd> x) {
  below_.resize(most_rows_below_, x.cols());
  const int sides = static_cast<int>(x.cols()), stride = static_cast<int>(x.outerStride()), one = 1;
  const int below_stride = static_cast<int>(below_.rows());
  constexpr double plus = 1, minus = -1;
  for (std::ptrdiff_t s = 0; s < supernodes_; ++s) {
    check_cancelled();
    const int columns = columns_of(s), rows = rows_of(s), below = rows - columns;
    const double* const panel = values_ + values_begin_[s];
    double* const own = x.data() + first_column_[s];
    if (x.middleRows(first_column_[s], columns).isZero(0)) continue;  // often the case where few unknowns have loads
    if (sides == 1)
      dtrsv_("L", "N", "N", &columns, panel, &rows, own, &one);
    else
      dtrsm_("L", "L", "N", "N", &columns, &sides, &plus, panel, &rows, own, &stride);
    if (below == 0) continue;
    gather(s, x);
    if (sides == 1)
      dgemv_("N", &below, &columns, &minus, panel + columns, &rows, own, &one, &plus, below_.data(), &one);
    else
      dgemm_("N", "N", &below, &sides, &columns, &minus, panel + columns, &rows, own, &stride, &plus, below_.data(),
             &below_stride);
    const Index* const row = row_ + rows_begin_[s] + columns;
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (int r = 0; r < below; ++r) x(row[r], c) = below_(r, c);
  }
}

template <class Index>
void SupernodalFactor<Index>::solve_upper(Eigen::Ref<Eigen::MatrixXd> x) {
  below_.resize(most_rows_below_, x.cols());
  const int sides = static_cast<int>(x.cols()), stride = static_cast<int>(x.outerStride()), one = 1;
  const int below_stride = static_cast<int>(below_.rows());
  constexpr double plus = 1, minus = -1;
  for (std::ptrdiff_t s = supernodes_ - 1; s >= 0; --s) {
    check_cancelled();
    const int columns = columns_of(s), rows = rows_of(s), below = rows - columns;
    const double* const panel = values_ + values_begin_[s];
    double* const own = x.data() + first_column_[s];
    if (below > 0) {
      gather(s, x);
      if (sides == 1)
        dgemv_("C", &below, &columns, &minus, panel + columns, &rows, below_.data(), &one, &plus, own, &one);
      else
        dgemm_("C", "N", &columns, &sides, &below, &minus, panel + columns, &rows, below_.data(), &below_stride, &plus,
               own, &stride);
    }
    if (sides == 1)
      dtrsv_("L", "C", "N", &columns, panel, &rows, own, &one);
    else
      dtrsm_("L", "L", "C", "N", &columns, &sides, &plus, panel, &rows, own, &stride);
  }
}

template <class Index>
std::vector<char> SupernodalFactor<Index>::supernodes_needed_for(const std::vector<int>& places) const {
  std::vector<char> marked(static_cast<std::size_t>(supernodes_), 0);
  for (int place : places) {
    for (;;) {
      const auto s = std::upper_bound(first_column_, first_column_ + supernodes_ + 1, place) - first_column_ - 1;
      if (marked[static_cast<std::size_t>(s)]) break;
      marked[static_cast<std::size_t>(s)] = 1;
      if (rows_of(s) == columns_of(s)) break;
      place = static_cast<int>(row_[rows_begin_[s] + columns_of(s)]);
    }
  }
  return marked;
}

template <class Index>
void SupernodalFactor<Index>::solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known,
                                             const std::vector<char>* marked) const {
  const int unknown = size_ - known;
  Eigen::MatrixXd later;  // values of the unknowns that a supernode's columns depend on
  for (std::ptrdiff_t s = supernodes_ - 1; s >= 0; --s) {
    const int first = static_cast<int>(first_column_[s]);
    const int columns = std::min(first + columns_of(s), unknown) - first;
    if (columns <= 0 || (marked && !(*marked)[static_cast<std::size_t>(s)])) continue;
    const int rows = rows_of(s);
    const Eigen::Map<const Eigen::MatrixXd> panel(values_ + values_begin_[s], rows, columns);
    auto own = transposed.middleCols(first_column_[s], columns);
    later.resize(transposed.rows(), rows - columns);
    for (int r = columns; r < rows; ++r) later.col(r - columns) = transposed.col(row_[rows_begin_[s] + r]);
    if (rows > columns) own.noalias() -= later * panel.bottomRows(rows - columns);
    panel.topRows(columns).triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(own);
  }
}

template class SupernodalFactor<int>;
template class SupernodalFactor<SuiteSparse_long>;

}  // namespace bempd::linalg

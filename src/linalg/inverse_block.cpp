#include "linalg/inverse_block.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"

namespace bempd::linalg {

namespace {

// Columns of the factor, the diagonal entry first: of L in L L^T, or of L in L D L^T with D on the diagonal.
class FactorColumns {
 public:
  explicit FactorColumns(const cholmod_factor& factor)
      : factor_(factor), values_(static_cast<const double*>(factor.x)) {
    if (!factor.is_super) return;
    const int* super = static_cast<const int*>(factor.super);
    supernode_of_.resize(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
      std::fill(supernode_of_.begin() + super[s], supernode_of_.begin() + super[s + 1], static_cast<int>(s));
  }

  bool has_roots() const { return factor_.is_super || factor_.is_ll; }

  // Calls visit(row, value) for the entries of a column, rows ascending.
  template <class Visit>
  void for_each(int column, const Visit& visit) const {
    if (!factor_.is_super) {
      const int begin = static_cast<const int*>(factor_.p)[column];
      const int count = static_cast<const int*>(factor_.nz)[column];
      const int* rows = static_cast<const int*>(factor_.i);
      for (int k = begin; k < begin + count; ++k) visit(rows[k], values_[k]);
      return;
    }
    const int s = supernode_of_[static_cast<std::size_t>(column)];
    const int* rows = static_cast<const int*>(factor_.s);
    const int* pi = static_cast<const int*>(factor_.pi);
    const int within = column - static_cast<const int*>(factor_.super)[s], count = pi[s + 1] - pi[s];
    const double* panel =
        values_ + static_cast<const int*>(factor_.px)[s] + static_cast<std::ptrdiff_t>(within) * count;
    for (int k = within; k < count; ++k) visit(rows[pi[s] + k], panel[k]);
  }

  int parent(int column) const {
    int found = -1, entry = 0;
    for_each(column, [&](int row, double) {
      if (entry++ == 1) found = row;
    });
    return found;
  }

 private:
  const cholmod_factor& factor_;
  const double* values_;
  std::vector<int> supernode_of_;
};

}  // namespace

// Computes the block as y^T y, or y^T D^-1 y, where L y = b and the columns of b are the unit vectors of the places.
Eigen::MatrixXd inverse_block(const cholmod_factor& factor, const std::vector<int>& places) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const FactorColumns columns(factor);
  std::vector<int> way, row_of(factor.n, -1);
  for (const int place : places)
    for (int j = place; j >= 0 && row_of[static_cast<std::size_t>(j)] < 0; j = columns.parent(j)) {
      row_of[static_cast<std::size_t>(j)] = 0;
      way.push_back(j);
    }
  std::sort(way.begin(), way.end());
  for (std::size_t k = 0; k < way.size(); ++k) row_of[static_cast<std::size_t>(way[k])] = static_cast<int>(k);
  Rows y = Rows::Zero(static_cast<Eigen::Index>(way.size()), static_cast<Eigen::Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
    y(row_of[static_cast<std::size_t>(places[k])], static_cast<Eigen::Index>(k)) = 1;
  Eigen::VectorXd roots(y.rows());  // of D
  for (Eigen::Index k = 0; k < y.rows(); ++k) {
    if (k % 64 == 0) check_cancelled();
    columns.for_each(way[static_cast<std::size_t>(k)], [&](int row, double value) {
      if (row != way[static_cast<std::size_t>(k)]) {
        y.row(row_of[static_cast<std::size_t>(row)]) -= value * y.row(k);
      } else if (columns.has_roots()) {
        y.row(k) /= value;
      } else {
        roots[k] = std::sqrt(value);
      }
    });
  }
  if (!columns.has_roots()) y = roots.cwiseInverse().asDiagonal() * y;
  return y.transpose() * y;
}

}  // namespace bempd::linalg

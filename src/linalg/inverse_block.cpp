#include "linalg/inverse_block.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"

namespace bempd::linalg {

namespace {

// Columns of CHOLMOD's factor L, each from its diagonal entry down. For a factor L D L^T, the diagonal entries are
// those of D.
template <class Index>
class FactorColumns {
 public:
  explicit FactorColumns(const cholmod_factor& factor)
      : factor_(factor), values_(static_cast<const double*>(factor.x)) {
    if (!factor.is_super) return;
    const Index* super = static_cast<const Index*>(factor.super);
    supernode_of_.resize(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
      std::fill(supernode_of_.begin() + super[s], supernode_of_.begin() + super[s + 1], static_cast<int>(s));
  }

  bool has_roots() const { return factor_.is_super || factor_.is_ll; }

  // Calls visit(row, value) for the entries of a column, rows ascending.
  template <class Visit>
  void for_each(int column, const Visit& visit) const {
    if (!factor_.is_super) {
      const Index begin = static_cast<const Index*>(factor_.p)[column];
      const Index count = static_cast<const Index*>(factor_.nz)[column];
      const Index* rows = static_cast<const Index*>(factor_.i);
      for (Index k = begin; k < begin + count; ++k) visit(static_cast<int>(rows[k]), values_[k]);
      return;
    }
    const int s = supernode_of_[static_cast<std::size_t>(column)];
    const Index* rows = static_cast<const Index*>(factor_.s);
    const Index* pi = static_cast<const Index*>(factor_.pi);
    const auto within = static_cast<int>(column - static_cast<const Index*>(factor_.super)[s]);
    const auto count = static_cast<int>(pi[s + 1] - pi[s]);
    const double* panel =
        values_ + static_cast<const Index*>(factor_.px)[s] + static_cast<std::ptrdiff_t>(within) * count;
    for (int k = within; k < count; ++k) visit(static_cast<int>(rows[pi[s] + k]), panel[k]);
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

// Computes the block as y^T y (factor L L^T) or y^T D^-1 y (factor L D L^T), where L y = b and the columns of b are the
// unit vectors of the places.
template <class Index>
Eigen::MatrixXd inverse_block(const cholmod_factor& factor, const std::vector<int>& places) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const FactorColumns<Index> columns(factor);
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
  Eigen::VectorXd roots(y.rows());  // square roots of the entries of D
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

template Eigen::MatrixXd inverse_block<int>(const cholmod_factor&, const std::vector<int>&);
template Eigen::MatrixXd inverse_block<SuiteSparse_long>(const cholmod_factor&, const std::vector<int>&);

}  // namespace bempd::linalg

#include "linalg/up_looking_ldlt.hpp"

#include <Eigen/OrderingMethods>

#include "cancellation.hpp"
#include "linalg/expected_time.hpp"
#include "phase.hpp"

namespace bempd::linalg {

std::vector<int> minimum_degree(const Eigen::SparseMatrix<double>& lower) {
  Eigen::SparseMatrix<double> whole = lower.selfadjointView<Eigen::Lower>();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
  Eigen::AMDOrdering<int>()(whole, inverse);
  return {inverse.indices().begin(), inverse.indices().end()};
}

Eigen::SparseMatrix<double> upper_in_order(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to_place(lower.rows());
  for (std::size_t k = 0; k < order.size(); ++k) to_place.indices()[order[k]] = static_cast<int>(k);
  Eigen::SparseMatrix<double> result(lower.rows(), lower.cols());
  result.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(to_place);
  return result;
}

void UpLookingLDLT::analyse(const Matrix& upper) {
  const int n = static_cast<int>(upper.cols());
  const auto size = static_cast<std::size_t>(n);
  parent_.assign(size, -1), seen_.assign(size, -1), length_.assign(size, 0), pattern_.assign(size, 0);
  for (int k = 0; k < n; ++k) {
    seen_[k] = k;
    for (Matrix::InnerIterator it(upper, k); it; ++it) {
      for (int i = static_cast<int>(it.row()); i < k && seen_[i] != k; i = parent_[i]) {
        if (parent_[i] == -1) parent_[i] = k;
        ++length_[i];
        seen_[i] = k;
      }
    }
  }
  unit_lower_.resize(n, n);
  for (int k = 0; k < n; ++k) unit_lower_.outerIndexPtr()[k + 1] = unit_lower_.outerIndexPtr()[k] + length_[k];
  unit_lower_.resizeNonZeros(unit_lower_.outerIndexPtr()[n]);
}

int UpLookingLDLT::pattern_of_row(const Matrix& upper, int k) {
  int top = static_cast<int>(upper.cols());
  seen_[k] = k;
  for (Matrix::InnerIterator it(upper, k); it; ++it) {
    int count = 0;
    for (int i = static_cast<int>(it.row()); i < k && seen_[i] != k; i = parent_[i]) {
      pattern_[count++] = i;
      seen_[i] = k;
    }
    while (count > 0) pattern_[--top] = pattern_[--count];
  }
  return top;
}

bool UpLookingLDLT::factorize(const Matrix& upper) {
  const int n = static_cast<int>(upper.cols());
  const int* const begin = unit_lower_.outerIndexPtr();
  int* const rows = unit_lower_.innerIndexPtr();
  double* const values = unit_lower_.valuePtr();
  double work = 0, done = 0;
  for (int k = 0; k < n; ++k) work += 0.5 * length_[k] * (length_[k] + 1.0);
  const Phase phase("sparse factorization", work, expected_time_of_entries(work));
  Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
  pivots_.resize(n);
  std::fill(seen_.begin(), seen_.end(), -1);
  std::fill(length_.begin(), length_.end(), 0);
  for (int k = 0; k < n; ++k) {
    check_cancelled();
    phase.reach(done);
    for (Matrix::InnerIterator it(upper, k); it; ++it) row[it.row()] += it.value();
    double pivot = row[k];
    row[k] = 0;
    for (int top = pattern_of_row(upper, k); top < n; ++top) {
      const int i = pattern_[top];
      const double entry = row[i], scaled = entry / pivots_[i];
      row[i] = 0;
      const int end = begin[i] + length_[i];
      for (int p = begin[i]; p < end; ++p) row[rows[p]] -= values[p] * entry;
      done += length_[i] + 1;
      pivot -= scaled * entry;
      rows[end] = k;
      values[end] = scaled;
      ++length_[i];
    }
    pivots_[k] = pivot;
    if (pivot == 0) return false;
  }
  return true;
}

void UpLookingLDLT::solve_forward(Eigen::Ref<Eigen::MatrixXd> x) const {
  unit_lower_.triangularView<Eigen::UnitLower>().solveInPlace(x);
}

void UpLookingLDLT::solve_backward(Eigen::Ref<Eigen::MatrixXd> x) const {
  unit_lower_.transpose().triangularView<Eigen::UnitUpper>().solveInPlace(x);
}

}  // namespace bempd::linalg

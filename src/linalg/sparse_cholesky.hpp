#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>

namespace bempd::linalg {

enum class Change { add, remove };

// Smallest pivot that counts as positive, relative to the diagonal entry it started from: below it, the pivot is
// rounding noise of the elimination.
constexpr double singular_pivot_ratio = 1e-13;

// Cholesky factor of a sparse symmetric positive definite matrix, with low-rank changes. An object serves one thread at
// a time; different objects are independent. Out of memory throws std::bad_alloc, any other failure std::runtime_error.
class SparseCholesky {
 public:
  virtual ~SparseCholesky() = default;

  // Factorizes the matrix whose lower triangle is given. Returns false if it is not positive definite (a pivot ratio is
  // at most `singular_pivot_ratio`); then there is no factor. Ordering and analysis are kept while the pattern stays
  // the same, so entries that become zero are best kept as explicit zeros.
  virtual bool factorize(const Eigen::SparseMatrix<double>& lower) = 0;

  // Overwrites the right-hand sides with solutions, using the factor as it is now.
  virtual void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const = 0;

  // A <- A + C C^T (add) or A - C C^T (remove), C having few entries a column. Returns true if the factor now
  // represents the changed matrix; false if it was left stale, so that solves only precondition until the next
  // factorize. After a removal to a singular matrix the factor stays finite, with the lost pivots kept at
  // `singular_pivot_ratio` of the largest diagonal entry; smallest_pivot_ratio() tells.
  virtual bool update(const Eigen::SparseMatrix<double>& columns, Change change) = 0;

  // Smallest pivot over the diagonal entry of the matrix last factorized: near zero at a mechanism, and a lower bound
  // of nothing else (an ill-conditioned matrix can have large ratios). 1 for an empty matrix. Costs one pass over the
  // pivots.
  virtual double smallest_pivot_ratio() const = 0;

  // Stored entries of the factor.
  virtual std::int64_t factor_nonzeros() const = 0;
};

std::unique_ptr<SparseCholesky> make_sparse_cholesky();

// The backend this library was built with: "suitesparse" or "eigen".
const char* backend_name();

}  // namespace bempd::linalg

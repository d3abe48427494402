#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

namespace bempd::linalg {

enum class Change { add, remove };

// Smallest pivot that counts as nonzero, relative to what smallest_pivot_ratio() compares it with: below it, the pivot
// is rounding noise of the elimination.
constexpr double singular_pivot_ratio = 1e-13;

// Direct solver of a sparse square system, with low-rank changes where the method has them. An object serves one thread
// at a time; different objects are independent. Out of memory throws std::bad_alloc, any other failure
// std::runtime_error.
class SparseFactorization {
 public:
  virtual ~SparseFactorization() = default;

  // Factorizes the matrix, of which a symmetric method takes the lower triangle only. Returns false if the matrix is
  // singular (a pivot ratio is at most `singular_pivot_ratio`), has a number that is not finite, or does not suit the
  // method; then there is no factor. Ordering and analysis are kept while the pattern stays the same, so entries that
  // become zero are best kept as explicit zeros.
  virtual bool factorize(const Eigen::SparseMatrix<double>& matrix) = 0;

  // Overwrites the right-hand sides with solutions, using the factor as it is now. No iterative refinement.
  virtual void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const = 0;

  // Changes A to A + C C^T (add) or A - C C^T (remove), where C has few entries a column. Returns true if the factor
  // now represents the changed matrix; false if it was left stale, so that solves only precondition until the next
  // factorize.
  virtual bool update(const Eigen::SparseMatrix<double>& columns, Change change) = 0;

  // Smallest pivot relative to entries of the matrix last factorized, see the methods: near zero if something can move
  // freely. It is no measure of the condition (an ill-conditioned matrix can have large ratios). 1 for an empty matrix.
  // Costs one pass over the pivots.
  virtual double smallest_pivot_ratio() const = 0;

  // Number of stored entries of the factor.
  virtual std::int64_t factor_nonzeros() const = 0;
};

// Name of the backend this library was built with: "suitesparse" or "eigen".
const char* backend_name();

}  // namespace bempd::linalg

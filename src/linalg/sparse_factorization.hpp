#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

namespace bempd::linalg {

enum class Change { add, remove };

// Pivot ratio (see smallest_pivot_ratio()) up to which a pivot counts as zero: smaller pivots are rounding errors of
// the elimination.
constexpr double singular_pivot_ratio = 1e-13;

// Direct solver of a sparse square system, with low-rank changes if the method has them. One thread at a time may use
// an object; different objects are independent. Functions throw std::bad_alloc if memory is missing, std::runtime_error
// on other failures.
class SparseFactorization {
 public:
  virtual ~SparseFactorization() = default;

  // Factorizes the matrix; a symmetric method reads only its lower triangle. Returns false, without a factor, if the
  // matrix is singular (a pivot ratio of at most singular_pivot_ratio), has a number that is not finite, or does not
  // suit the method. Ordering and analysis are kept while the pattern stays the same, so entries that become zero are
  // best kept as explicit zeros.
  virtual bool factorize(const Eigen::SparseMatrix<double>& matrix) = 0;

  // Overwrites right-hand sides with solutions by the present factor, without iterative refinement.
  virtual void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const = 0;

  // Changes A to A + C C^T (add) or A - C C^T (remove), where C has few entries per column. Returns true if the factor
  // belongs to the changed matrix. After false the factor is stale, good only as a preconditioner until the next
  // factorize().
  virtual bool update(const Eigen::SparseMatrix<double>& columns, Change change) = 0;

  // Smallest ratio of a pivot to entries of the matrix last factorized; which entries depends on the method. It is near
  // zero if a part of the body can move freely. The ratio does not measure the condition, because an ill-conditioned
  // matrix can have large ratios. It is 1 for an empty matrix, and costs one pass over the pivots.
  virtual double smallest_pivot_ratio() const = 0;

  // Number of stored entries of the factor.
  virtual std::int64_t factor_nonzeros() const = 0;
};

// Name of the backend this library was built with: "suitesparse" or "eigen".
const char* backend_name();

}  // namespace bempd::linalg

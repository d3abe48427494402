#pragma once

#include <memory>
#include <vector>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Cholesky factor of a symmetric positive definite matrix: factorize() takes the lower triangle and refuses a matrix
// that is not positive definite. Pivot ratios are relative to the diagonal entries.
//
// After a removal to a singular matrix the factor stays finite, with the lost pivots kept at `singular_pivot_ratio` of
// the largest diagonal entry; smallest_pivot_ratio() shows that.
class SparseCholesky : public SparseFactorization {
 public:
  // Sets the order of elimination, which the next factorize() follows approximately; the last `kept_last` unknowns come
  // after all others. An empty order is found from the pattern.
  virtual void set_elimination_order(std::vector<int> order, int kept_last) = 0;

  // Order of the present factor: the unknown eliminated k-th.
  virtual const std::vector<int>& elimination_order() const = 0;

  // Halves of solve_in_place() with a factor A = L L^T that no update() has changed. solve_forward() takes right-hand
  // sides and leaves L^-1 of them in the order of elimination; the second takes such values and leaves the unknowns in
  // the same order, one set after the other in its columns, and keeps the last `known` of the unknowns as they are. The
  // third computes only these places and what they depend on; other entries may stay unchanged.
  virtual void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const = 0;
  virtual void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const = 0;
  virtual void solve_backward_at(const std::vector<int>& places, Eigen::Ref<Eigen::MatrixXd> transposed,
                                 int known) const = 0;

  // Block of A^-1 on some unknowns, with any factor.
  virtual Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const = 0;

  // Lower right corner of L: the Cholesky factor of the Schur complement on the last `size` unknowns.
  virtual Eigen::MatrixXd trailing_factor(int size) const = 0;
};

std::unique_ptr<SparseCholesky> make_sparse_cholesky();

}  // namespace bempd::linalg

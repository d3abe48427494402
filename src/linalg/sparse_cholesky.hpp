#pragma once

#include <memory>
#include <vector>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Cholesky factor of a sparse symmetric positive definite matrix. factorize() reads the lower triangle and returns
// false if the matrix is not positive definite. Pivot ratios are relative to the diagonal entries.
//
// After a removal that makes the matrix singular the factor stays finite: the lost pivots are kept at
// singular_pivot_ratio times the largest diagonal entry, which smallest_pivot_ratio() shows.
class SparseCholesky : public SparseFactorization {
 public:
  // Sets the order of elimination that the next factorize() follows approximately; the last `kept_last` unknowns come
  // after all others. If `order` is empty, an order is found from the pattern.
  virtual void set_elimination_order(std::vector<int> order, int kept_last) = 0;

  // Order of elimination of the present factor: entry k is the unknown that is eliminated as the k-th.
  virtual const std::vector<int>& elimination_order() const = 0;

  // First half of solve_in_place(), with a factor A = L L^T that no update() has changed: multiplies right-hand sides
  // by L^-1, in the order of elimination. A solver from outside (external_cholesky.hpp) computes only the values of the
  // kept unknowns and leaves the other values as they are.
  virtual void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const = 0;
  // Second half of solve_in_place(): replaces the results of solve_forward(), transposed (one row per right-hand side),
  // by the unknowns in the same order. The last `known` unknowns are given and stay.
  virtual void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const = 0;
  // Second half of a solution, computed only for the unknowns at `places` and for the unknowns that these depend on.
  // Other entries may be left unsolved.
  virtual void solve_backward_at(const std::vector<int>& places, Eigen::Ref<Eigen::MatrixXd> transposed,
                                 int known) const = 0;

  // Block of A^-1 for some unknowns, with any factor, changed or not.
  virtual Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const = 0;

  // Lower right corner of L: the Cholesky factor of the Schur complement on the last `size` unknowns.
  virtual Eigen::MatrixXd trailing_factor(int size) const = 0;

  using TwoColumns = Eigen::Matrix<double, Eigen::Dynamic, 2>;
  // Products p^T A^-1 q of right-hand sides p and q, where the last `known` unknowns are held at 0. `a` and `b` are the
  // results of solve_forward() for p and q.
  virtual Eigen::MatrixXd eliminated_products(const Eigen::MatrixXd& a, const TwoColumns& b, int known) const;
};

// Factorization that the present call uses: the library's own, or that of a solver from outside (SolverScope).
std::unique_ptr<SparseCholesky> make_sparse_cholesky();

// Factorization of the backend that the library was built with. Wide indices have 64 bits where the backend has a
// choice.
std::unique_ptr<SparseCholesky> own_cholesky(bool wide_indices);

}  // namespace bempd::linalg

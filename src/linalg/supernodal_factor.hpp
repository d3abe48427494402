#pragma once

#include <cholmod.h>

#include <Eigen/Core>

namespace bempd::linalg {

// Calls visit(j, d_j) for every pivot of CHOLMOD's L L^T (supernodal or simplicial) or L D L^T.
template <class Visit>
void for_each_pivot(const cholmod_factor& factor, Visit visit) {
  const double* x = static_cast<const double*>(factor.x);
  if (!factor.is_super) {
    const int* p = static_cast<const int*>(factor.p);
    for (int j = 0; j < static_cast<int>(factor.n); ++j) visit(j, factor.is_ll ? x[p[j]] * x[p[j]] : x[p[j]]);
    return;
  }
  const int* super = static_cast<const int*>(factor.super);
  const int* pi = static_cast<const int*>(factor.pi);
  const int* px = static_cast<const int*>(factor.px);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int rows = pi[s + 1] - pi[s];
    for (int k = 0; k < super[s + 1] - super[s]; ++k) {
      const double diagonal = x[px[s] + k + static_cast<std::ptrdiff_t>(k) * rows];
      visit(super[s] + k, diagonal * diagonal);
    }
  }
}

// Reads what CHOLMOD has no call for from its supernodal factor L: columns lie in dense panels, one a supernode. Rows
// and columns are in the order of elimination.
class SupernodalFactor {
 public:
  explicit SupernodalFactor(const cholmod_factor& factor);

  // The last rows and columns of L, a lower triangle.
  Eigen::MatrixXd trailing_block(int size) const;

  // Solves L^T x = b for rows of right-hand sides whose last `known` entries are solutions already.
  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const;

 private:
  std::ptrdiff_t supernodes_;
  int size_;
  const double* values_;
  const int *first_column_, *rows_begin_, *values_begin_, *row_;  // of a supernode; of an entry of its panel's rows
};

}  // namespace bempd::linalg

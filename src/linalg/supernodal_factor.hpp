#pragma once

#include <cholmod.h>

#include <Eigen/Core>
#include <vector>

namespace bempd::linalg {

// Calls visit(j, d_j) for every pivot d_j of CHOLMOD's factor (j: place in the order of elimination), whether it is L
// L^T (supernodal or simplicial) or L D L^T.
template <class Index, class Visit>
void for_each_pivot(const cholmod_factor& factor, Visit visit) {
  const double* x = static_cast<const double*>(factor.x);
  if (!factor.is_super) {
    const Index* p = static_cast<const Index*>(factor.p);
    for (Index j = 0; j < static_cast<Index>(factor.n); ++j) visit(j, factor.is_ll ? x[p[j]] * x[p[j]] : x[p[j]]);
    return;
  }
  const Index* super = static_cast<const Index*>(factor.super);
  const Index* pi = static_cast<const Index*>(factor.pi);
  const Index* px = static_cast<const Index*>(factor.px);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const Index rows = pi[s + 1] - pi[s];
    for (Index k = 0; k < super[s + 1] - super[s]; ++k) {
      const double diagonal = x[px[s] + k + static_cast<std::ptrdiff_t>(k) * rows];
      visit(super[s] + k, diagonal * diagonal);
    }
  }
}

// View of CHOLMOD's supernodal factor L: its columns lie in dense panels, one for each supernode. Rows and columns are
// in the order of elimination.
template <class Index>
class SupernodalFactor {
 public:
  explicit SupernodalFactor(const cholmod_factor& factor);

  // Last `size` rows and columns of L, a lower triangle.
  Eigen::MatrixXd trailing_block(int size) const;

  // Solution with L: x <- L^-1 x, by the BLAS calls of CHOLMOD's own function, which cannot be cancelled and does not
  // report all cases of missing memory.
  void solve_lower(Eigen::Ref<Eigen::MatrixXd> x);
  void solve_upper(Eigen::Ref<Eigen::MatrixXd> x);  // x <- L^-T x, in the same way

  // Solves L^T x = b, where each row of `transposed` is a right-hand side whose last `known` entries are already
  // solutions. Only the supernodes flagged in `marked` are computed (null: all).
  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known,
                      const std::vector<char>* marked = nullptr) const;
  // Flags of the supernodes on which solutions at `places` depend: the supernodes that contain `places`, and all on the
  // paths from them to the root of the elimination tree.
  std::vector<char> supernodes_needed_for(const std::vector<int>& places) const;

 private:
  int columns_of(std::ptrdiff_t s) const { return static_cast<int>(first_column_[s + 1] - first_column_[s]); }
  int rows_of(std::ptrdiff_t s) const { return static_cast<int>(rows_begin_[s + 1] - rows_begin_[s]); }
  void gather(std::ptrdiff_t s, const Eigen::Ref<const Eigen::MatrixXd>& x);

  std::ptrdiff_t supernodes_;
  int size_;
  const double* values_;
  const Index *first_column_, *rows_begin_, *values_begin_, *row_;  // begin of each supernode; row of each panel row
  Eigen::Index most_rows_below_;
  Eigen::MatrixXd below_;  // entries of right-hand sides below a supernode's triangle
};

}  // namespace bempd::linalg

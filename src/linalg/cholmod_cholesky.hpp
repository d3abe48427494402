#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "cancellation.hpp"
#include "linalg/cholmod_handles.hpp"
#include "linalg/cholmod_views.hpp"
#include "linalg/inverse_block.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "linalg/sparsity_pattern.hpp"
#include "linalg/supernodal_cholesky.hpp"
#include "linalg/supernodal_factor.hpp"

namespace bempd::linalg {

// Number of factor entries above which one solution takes more than some 50 ms.
constexpr std::int64_t entries_of_a_long_solution = 50'000'000;

// Cholesky factor by CHOLMOD's analysis and changes, and the library's own supernodal factorization.
template <class Index>
class CholmodCholesky final : public SparseCholesky {
 public:
  using SparseMatrix = Eigen::SparseMatrix<double>;

  CholmodCholesky() {
    // Supernodal factors are used for all sizes: L L^T notices a negative pivot, CHOLMOD's simplicial L D L^T does not.
    common_->supernodal = CHOLMOD_SUPERNODAL;
    // AMD is the only ordering. CHOLMOD's other choice, METIS, reseeds the process-wide random generator and swaps
    // signal handlers, which an embedded library must not do to its host.
    common_->nmethods = 1;
    common_->method[0].ordering = CHOLMOD_AMD;
  }

  void set_elimination_order(std::vector<int> order, int kept_last) override {
    if (order == wanted_order_ && kept_last == kept_last_) return;
    wanted_order_ = std::move(order);
    kept_last_ = kept_last;
    pattern_.clear();
  }

  const std::vector<int>& elimination_order() const override { return order_; }

  bool factorize(const SparseMatrix& lower) override {
    assert(lower.rows() == lower.cols());
    if (!lower.isCompressed()) {
      SparseMatrix compressed = lower;
      compressed.makeCompressed();
      return factorize(compressed);
    }
    has_factor_ = false;
    diagonal_ = lower.diagonal();
    if (lower.rows() == 0) {
      factor_.reset();
      return has_factor_ = true;
    }
    if (!lower.coeffs().allFinite()) return false;
    prepare_factor(lower);
    common_->dbound = 0;
    check_cancelled();
    has_factor_ = factorize_supernodes<Index>(lower, *factor_.get()) && smallest_pivot_ratio() > singular_pivot_ratio;
    return has_factor_;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == diagonal_.size());
    if (rhs.size() == 0) return;
    if (!factor_->is_super && factor_nonzeros() < entries_of_a_long_solution) {
      triangular_solve(CHOLMOD_A, rhs);
      rhs = solution();
      return;
    }
    Eigen::MatrixXd ordered = rhs(order_, Eigen::all);
    if (factor_->is_super) {
      SupernodalFactor<Index> factor(*factor_.get());
      factor.solve_lower(ordered);
      factor.solve_upper(ordered);
    } else {
      // Long solutions are done in two halves with a check for cancellation between them; the result has the same
      // digits as that of a single call.
      triangular_solve(CHOLMOD_L, ordered);
      check_cancelled();
      ordered = solution();
      triangular_solve(CHOLMOD_DLt, ordered);
      ordered = solution();
    }
    rhs(order_, Eigen::all) = ordered;
  }

  void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && factor_->is_super && rhs.rows() == diagonal_.size());
    if (rhs.size() == 0) return;
    // Columns are copied one by one with checks for cancellation, because many long columns take a while.
    Eigen::MatrixXd ordered(rhs.rows(), rhs.cols());
    for (Eigen::Index c = 0; c < rhs.cols(); ++c) {
      check_cancelled();
      ordered.col(c) = rhs.col(c)(order_);
    }
    SupernodalFactor<Index>(*factor_.get()).solve_lower(ordered);
    for (Eigen::Index c = 0; c < rhs.cols(); ++c) {
      check_cancelled();
      rhs.col(c) = ordered.col(c);
    }
  }

  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    assert(has_factor_ && factor_->is_super && transposed.cols() == diagonal_.size());
    SupernodalFactor<Index>(*factor_.get()).solve_backward(transposed, known);
  }

  void solve_backward_at(const std::vector<int>& places, Eigen::Ref<Eigen::MatrixXd> transposed,
                         int known) const override {
    assert(has_factor_ && factor_->is_super && transposed.cols() == diagonal_.size());
    const SupernodalFactor<Index> factor(*factor_.get());
    const std::vector<char> asked = factor.supernodes_needed_for(places);
    factor.solve_backward(transposed, known, &asked);
  }

  Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const override {
    assert(has_factor_);
    std::vector<int> places(unknowns.size());
    std::transform(unknowns.begin(), unknowns.end(), places.begin(), [&](int u) { return position_[u]; });
    return linalg::inverse_block<Index>(*factor_.get(), places);
  }

  Eigen::MatrixXd trailing_factor(int size) const override {
    assert(has_factor_ && factor_->is_super);
    return SupernodalFactor<Index>(*factor_.get()).trailing_block(size);
  }

  bool update(const SparseMatrix& columns, Change change) override {
    assert(has_factor_ && columns.rows() == diagonal_.size());
    if (columns.nonZeros() == 0) return true;
    has_factor_ = false;  // until this call succeeds
    // The factor becomes simplicial only at its first change, so that runs without changes keep the faster supernodal
    // solutions.
    if (factor_->is_super) {
      Cholmod<Index>::change_factor(CHOLMOD_REAL, 0, 0, 0, 1, factor_.get(), common_.get());
      common_.check();
    }
    const SparseMatrix permuted = in_elimination_order(columns);
    CholmodMatrix<Index> c(permuted, 0);
    common_->dbound = singular_pivot_ratio * diagonal_.maxCoeff();
    Cholmod<Index>::update(change == Change::add ? 1 : 0, c.get(), factor_.get(), common_.get());
    common_.check();
    return has_factor_ = true;
  }

  double smallest_pivot_ratio() const override {
    double smallest = diagonal_.size() == 0 ? 1 : std::numeric_limits<double>::infinity();
    if (!factor_) return smallest;
    const Index* order = static_cast<const Index*>(factor_->Perm);
    for_each_pivot<Index>(*factor_.get(), [&](Index j, double pivot) {
      const double ratio = pivot / diagonal_[order[j]];
      if (!(ratio >= smallest)) smallest = ratio;  // a NaN wins
    });
    return smallest;
  }

  std::int64_t factor_nonzeros() const override {
    if (!factor_) return 0;
    if (factor_->is_super) return static_cast<std::int64_t>(factor_->xsize);
    const Index* counts = static_cast<const Index*>(factor_->nz);
    return std::accumulate(counts, counts + factor_->n, std::int64_t{0});
  }

 private:
  // Sets `factor_` to a supernodal factor without values, analysed for the pattern of `lower`.
  void prepare_factor(const SparseMatrix& lower) {
    if (!analysis_ || !pattern_.matches(lower)) {
      factor_.reset();
      analysis_.reset();
      pattern_.clear();
      analyse(lower);
      const Index* const found = static_cast<const Index*>(analysis_->Perm);
      order_.assign(found, found + lower.cols());
      position_.resize(order_.size());
      for (std::size_t k = 0; k < order_.size(); ++k) position_[order_[k]] = static_cast<int>(k);
      pattern_.assign(lower);  // last, so that a failure before leads to a new analysis
    }
    // A factor that was changed is simplicial, so the next factor is made from a copy of the analysis.
    if (!factor_ || !factor_->is_super) {
      factor_.reset(Cholmod<Index>::copy_factor(analysis_.get(), common_.get()));
      common_.check();
      Cholmod<Index>::change_factor(CHOLMOD_REAL, 1, 1, 1, 1, factor_.get(), common_.get());
      if (common_->status != CHOLMOD_OK) factor_.reset();  // without memory for its values a factor is useless
      common_.check();
      use_large_pages(factor_->x, factor_->xsize * sizeof(double));
    }
  }

  void analyse(const SparseMatrix& lower) {
    CholmodMatrix<Index> matrix(lower, -1);
    std::vector<Index> wanted(wanted_order_.begin(), wanted_order_.end());
    const bool given = !wanted_order_.empty();
    common_->method[0].ordering = given ? CHOLMOD_GIVEN : CHOLMOD_AMD;
    // Postordering gathers columns into larger supernodes, but may move unknowns that must come last; the analysis is
    // then repeated without postordering.
    for (const int postorder : {1, 0}) {
      common_->postorder = postorder;
      analysis_.reset(
          Cholmod<Index>::analyze(matrix.get(), given ? wanted.data() : nullptr, nullptr, 0, common_.get()));
      common_.check();
      if (kept_are_last()) return;
    }
  }

  bool kept_are_last() const {
    const Index* found = static_cast<const Index*>(analysis_->Perm);
    const auto last = [&](const auto* end) {
      std::vector<Index> set(end - kept_last_, end);
      std::sort(set.begin(), set.end());
      return set;
    };
    return last(found + analysis_->n) == last(wanted_order_.data() + wanted_order_.size());
  }

  // Solves a triangular system and stores the result in solution().
  void triangular_solve(int system, Eigen::Ref<Eigen::MatrixXd> rhs) const {
    cholmod_dense b = view(rhs);
    Cholmod<Index>::solve(system, factor_.get(), &b, nullptr, solution_.slot(), nullptr, work_y_.slot(), work_e_.slot(),
                          common_.get());
    common_.check();
  }
  Eigen::Map<const Eigen::MatrixXd> solution() const {
    return {static_cast<const double*>(solution_->x), static_cast<Eigen::Index>(solution_->nrow),
            static_cast<Eigen::Index>(solution_->ncol)};
  }

  SparseMatrix in_elimination_order(const SparseMatrix& columns) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(columns.nonZeros()));
    for (int k = 0; k < columns.outerSize(); ++k)
      for (SparseMatrix::InnerIterator it(columns, k); it; ++it)
        entries.emplace_back(position_[it.row()], k, it.value());
    SparseMatrix permuted(columns.rows(), columns.cols());
    permuted.setFromTriplets(entries.begin(), entries.end());
    return permuted;
  }

  mutable CholmodCommon<Index> common_;
  CholmodFactor<Index> analysis_{common_}, factor_{common_};
  mutable CholmodDense<Index> solution_{common_}, work_y_{common_}, work_e_{common_};
  Eigen::VectorXd diagonal_;       // diagonal of the matrix last factorized
  SparsityPattern<int> pattern_;   // pattern of `analysis_`
  std::vector<int> wanted_order_;  // empty: CHOLMOD chooses
  int kept_last_ = 0;
  std::vector<int> order_, position_;  // unknown eliminated as the k-th, and its inverse
  bool has_factor_ = false;
};

}  // namespace bempd::linalg

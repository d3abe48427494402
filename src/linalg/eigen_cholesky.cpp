#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "linalg/sparse_cholesky.hpp"
#include "linalg/sparsity_pattern.hpp"
#include "linalg/up_looking_ldlt.hpp"

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

class EigenCholesky final : public SparseCholesky {
 public:
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
    if (lower.rows() == 0) return has_factor_ = true;
    if (!lower.coeffs().allFinite()) return false;
    analyse(lower);
    has_factor_ = factor_.factorize(permuted(lower)) && smallest_pivot_ratio() > singular_pivot_ratio;
    return has_factor_;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == diagonal_.size());
    if (rhs.size() == 0) return;
    Eigen::MatrixXd ordered = rhs(order_, Eigen::all);
    factor_.solve_forward(ordered);
    ordered = factor_.pivots().cwiseInverse().asDiagonal() * ordered;
    factor_.solve_backward(ordered);
    rhs(order_, Eigen::all) = ordered;
  }

  void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    Eigen::MatrixXd ordered = rhs(order_, Eigen::all);
    factor_.solve_forward(ordered);
    rhs = factor_.pivots().cwiseSqrt().cwiseInverse().asDiagonal() * ordered;
  }

  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    const SparseMatrix& lower = factor_.unit_lower();
    const Eigen::VectorXd& pivots = factor_.pivots();
    for (Eigen::Index j = lower.cols() - known - 1; j >= 0; --j) {
      transposed.col(j) /= std::sqrt(pivots[j]);
      for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
        transposed.col(j) -= it.value() * transposed.col(it.row());
      }
    }
  }

  void solve_backward_at(const std::vector<int>&, Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    solve_backward(transposed, known);
  }

  Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const override {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(diagonal_.size(), static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t k = 0; k < unknowns.size(); ++k) columns(unknowns[k], static_cast<Eigen::Index>(k)) = 1;
    solve_in_place(columns);
    return columns(unknowns, Eigen::all);
  }

  Eigen::MatrixXd trailing_factor(int size) const override {
    const SparseMatrix& lower = factor_.unit_lower();
    const Eigen::Index first = lower.rows() - size;
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      const double root = std::sqrt(factor_.pivots()[first + j]);
      block(j, j) = root;
      for (SparseMatrix::InnerIterator it(lower, first + j); it; ++it) block(it.row() - first, j) = it.value() * root;
    }
    return block;
  }

  bool update(const SparseMatrix& columns, Change) override {
    assert(has_factor_ && columns.rows() == diagonal_.size());
    return columns.nonZeros() == 0;  // Eigen has no low-rank change of a sparse factor
  }

  double smallest_pivot_ratio() const override {
    if (diagonal_.size() == 0) return 1;
    const Eigen::VectorXd scale = diagonal_(order_);
    double smallest = std::numeric_limits<double>::infinity();
    const Eigen::VectorXd& pivots = factor_.pivots();
    for (Eigen::Index j = 0; j < pivots.size(); ++j) {
      const double ratio = pivots[j] / scale[j];
      if (!(ratio >= smallest)) smallest = ratio;  // a NaN wins
    }
    return smallest;
  }

  std::int64_t factor_nonzeros() const override {
    return diagonal_.size() == 0 ? 0 : factor_.unit_lower().nonZeros() + diagonal_.size();
  }

 private:
  void analyse(const SparseMatrix& lower) {
    if (pattern_.matches(lower)) return;
    pattern_.clear();  // an exception on the way must not leave a pattern without its analysis
    order_ = wanted_order_.empty() ? minimum_degree(lower) : wanted_order_;
    factor_.analyse(permuted(lower));
    pattern_.assign(lower);
  }

  // Upper triangle of the matrix in the order of elimination, with sorted columns.
  SparseMatrix permuted(const SparseMatrix& lower) const {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to_place(lower.rows());
    for (std::size_t k = 0; k < order_.size(); ++k) to_place.indices()[order_[k]] = static_cast<int>(k);
    SparseMatrix result(lower.rows(), lower.cols());
    result.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(to_place);
    return result.transpose();
  }

  UpLookingLDLT factor_;
  std::vector<int> wanted_order_, order_;  // entry k: unknown that is eliminated as the k-th
  int kept_last_ = 0;
  Eigen::VectorXd diagonal_;      // diagonal of the matrix last factorized
  SparsityPattern<int> pattern_;  // pattern that was analysed
  bool has_factor_ = false;
};

}  // namespace

std::unique_ptr<SparseCholesky> own_cholesky(bool) { return std::make_unique<EigenCholesky>(); }

const char* backend_name() { return "eigen"; }

}  // namespace bempd::linalg

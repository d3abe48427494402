#include <Eigen/SparseCholesky>
#include <cassert>
#include <limits>

#include "linalg/sparse_cholesky.hpp"
#include "linalg/sparsity_pattern.hpp"

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

class EigenCholesky final : public SparseCholesky {
 public:
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
    factor_.factorize(lower);
    has_factor_ = factor_.info() == Eigen::Success && smallest_pivot_ratio() > singular_pivot_ratio;
    return has_factor_;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == diagonal_.size());
    if (rhs.size() > 0) rhs = factor_.solve(rhs).eval();
  }

  bool update(const SparseMatrix& columns, Change) override {
    assert(has_factor_ && columns.rows() == diagonal_.size());
    return columns.nonZeros() == 0;  // Eigen has no low-rank change of a sparse factor
  }

  double smallest_pivot_ratio() const override {
    if (diagonal_.size() == 0) return 1;
    const Eigen::VectorXd scale = factor_.permutationP() * diagonal_;
    double smallest = std::numeric_limits<double>::infinity();
    const Eigen::VectorXd pivots = factor_.vectorD();
    for (Eigen::Index j = 0; j < pivots.size(); ++j) {
      const double ratio = pivots[j] / scale[j];
      if (!(ratio >= smallest)) smallest = ratio;  // a NaN wins
    }
    return smallest;
  }

  std::int64_t factor_nonzeros() const override {
    return diagonal_.size() == 0 ? 0 : factor_.matrixL().nestedExpression().nonZeros() + diagonal_.size();
  }

 private:
  void analyse(const SparseMatrix& lower) {
    if (pattern_.matches(lower)) return;
    pattern_.clear();  // an exception on the way must not leave a pattern without its analysis
    factor_.analyzePattern(lower);
    pattern_.assign(lower);
  }

  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
  Eigen::VectorXd diagonal_;      // of the matrix last factorized
  SparsityPattern<int> pattern_;  // what was analysed
  bool has_factor_ = false;
};

}  // namespace

std::unique_ptr<SparseCholesky> make_sparse_cholesky() { return std::make_unique<EigenCholesky>(); }

const char* backend_name() { return "eigen"; }

}  // namespace bempd::linalg

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <cassert>
#include <limits>
#include <new>

#include "linalg/row_scaling.hpp"
#include "linalg/sparse_lu.hpp"
#include "linalg/sparsity_pattern.hpp"

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
// Eigen counts the entries of the factor in the index type of the matrix; 32 bits would overflow in silence.
using LongMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

// Minimum degree of A + A^T. Eigen's own returns the old place of a new column, its LU wants the new place of an old
// one.
struct MinimumDegree {
  using PermutationType = Eigen::AMDOrdering<std::int64_t>::PermutationType;
  void operator()(const LongMatrix& matrix, PermutationType& permutation) const {
    PermutationType order;
    Eigen::AMDOrdering<std::int64_t>()(matrix, order);
    permutation = order.inverse();
  }
};

// Eigen's solver, opened for its pivots.
class Factor : public Eigen::SparseLU<LongMatrix, MinimumDegree> {
 public:
  Factor() {
    // The systems have a symmetric pattern and usually a good diagonal: ordering for the pattern of A + A^T and keeping
    // a diagonal pivot that is not much smaller than the best leaves far less fill than full partial pivoting.
    isSymmetric(true);
    setPivotThreshold(0.1);
  }

  // U's diagonal blocks are stored with L; rows come in no particular order.
  double pivot(Eigen::Index j) const {
    for (SCMatrix::InnerIterator it(m_Lstore, j); it; ++it)
      if (it.row() == j) return it.value();
    return 0;
  }

  // Eigen reports both a singular matrix and memory that ran out as a numerical issue.
  void throw_if_out_of_memory() const {
    if (info() != Eigen::Success && lastErrorMessage().starts_with("UNABLE TO")) throw std::bad_alloc();
  }
};

class EigenLU final : public SparseLU {
 public:
  bool factorize(const SparseMatrix& matrix) override {
    assert(matrix.rows() == matrix.cols());
    if (!matrix.isCompressed()) {
      SparseMatrix compressed = matrix;
      compressed.makeCompressed();
      return factorize(compressed);
    }
    has_factor_ = false;
    size_ = matrix.rows();
    if (size_ == 0) return has_factor_ = true;
    if (!matrix.coeffs().allFinite()) return false;
    row_scale_ = largest_in_rows(matrix);
    if (row_scale_.minCoeff() == 0) return false;
    column_scale_ = largest_in_columns(matrix, row_scale_);
    LongMatrix scaled = matrix;
    for (Eigen::Index j = 0; j < scaled.outerSize(); ++j)
      for (LongMatrix::InnerIterator it(scaled, j); it; ++it) it.valueRef() /= row_scale_[it.row()];
    if (!pattern_.matches(matrix)) {
      pattern_.clear();  // an exception on the way must not leave a pattern without its analysis
      factor_.analyzePattern(scaled);
      pattern_.assign(matrix);
    }
    factor_.factorize(scaled);
    factor_.throw_if_out_of_memory();
    return has_factor_ = factor_.info() == Eigen::Success && smallest_pivot_ratio() > singular_pivot_ratio;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == size_);
    if (rhs.size() == 0) return;
    for (Eigen::Index k = 0; k < rhs.cols(); ++k) rhs.col(k).array() /= row_scale_.array();
    rhs = factor_.solve(rhs).eval();
  }

  bool update(const SparseMatrix& columns, Change) override {
    assert(has_factor_ && columns.rows() == size_);
    return columns.nonZeros() == 0;
  }

  double smallest_pivot_ratio() const override {
    if (size_ == 0) return 1;
    double smallest = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < size_; ++j) {
      const Eigen::Index k = factor_.colsPermutation().indices()[j];
      const double ratio = std::abs(factor_.pivot(k)) / column_scale_[j];
      if (!(ratio >= smallest)) smallest = ratio;  // a NaN wins
    }
    return smallest;
  }

  std::int64_t factor_nonzeros() const override {
    return size_ == 0 ? 0 : factor_.nnzL() + factor_.nnzU() - size_;  // L has ones on its diagonal
  }

 private:
  // nnzL() and nnzU() are not const in Eigen 3.4.
  mutable Factor factor_;
  SparsityPattern<int> pattern_;  // what was analysed
  Eigen::Index size_ = 0;
  Eigen::VectorXd row_scale_, column_scale_;
  bool has_factor_ = false;
};

}  // namespace

std::unique_ptr<SparseLU> make_sparse_lu() { return std::make_unique<EigenLU>(); }

}  // namespace bempd::linalg

#include <umfpack.h>

#include <array>
#include <cassert>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "linalg/row_scaling.hpp"
#include "linalg/sparse_lu.hpp"
#include "linalg/sparsity_pattern.hpp"

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// UMFPACK counts the memory of a factor in the integers it is given, so 32 bits would limit the factor, not the matrix.
using Index = SuiteSparse_long;
static_assert(sizeof(Index) == 8);

// Owner of one of UMFPACK's two opaque objects; `slot` is where UMFPACK stores it.
template <void (*release)(void**)>
class UmfpackHandle {
 public:
  UmfpackHandle() = default;
  ~UmfpackHandle() { reset(); }
  UmfpackHandle(const UmfpackHandle&) = delete;
  UmfpackHandle& operator=(const UmfpackHandle&) = delete;

  void reset() {
    if (value_) release(&value_);
  }
  void* get() const { return value_; }
  void** slot() {
    reset();
    return &value_;
  }

 private:
  void* value_ = nullptr;
};

// A negative status is an error, a positive one a warning.
void check(Index status) {
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  if (status < 0) throw std::runtime_error("UMFPACK: error " + std::to_string(status));
}

class SuiteSparseLU final : public SparseLU {
 public:
  SuiteSparseLU() {
    umfpack_dl_defaults(control_.data());
    control_[UMFPACK_PRL] = 0;
    control_[UMFPACK_IRSTEP] = 0;
    control_[UMFPACK_SCALE] = UMFPACK_SCALE_MAX;
    // Never METIS, which reseeds the process-wide random generator and swaps signal handlers.
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_AMD;
  }

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
    const Eigen::VectorXd row_scale = largest_in_rows(matrix);
    if (row_scale.minCoeff() == 0) return false;
    analyse(matrix);
    const Index status = umfpack_dl_numeric(pattern_.column_start().data(), pattern_.rows().data(), matrix.valuePtr(),
                                            symbolic_.get(), numeric_.slot(), control_.data(), nullptr);
    check(status);
    if (status == UMFPACK_WARNING_singular_matrix) return false;
    column_scale_ = largest_in_columns(matrix, row_scale);
    return has_factor_ = smallest_pivot_ratio() > singular_pivot_ratio;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_ && rhs.rows() == size_);
    if (rhs.size() == 0) return;
    Eigen::VectorXd solution(size_);
    for (Eigen::Index k = 0; k < rhs.cols(); ++k) {
      // Without refinement the matrix itself is not needed.
      check(umfpack_dl_wsolve(UMFPACK_A, nullptr, nullptr, nullptr, solution.data(), rhs.col(k).data(), numeric_.get(),
                              control_.data(), nullptr, integer_work_.data(), real_work_.data()));
      rhs.col(k) = solution;
    }
  }

  bool update(const SparseMatrix& columns, Change) override {
    assert(has_factor_ && columns.rows() == size_);
    return columns.nonZeros() == 0;
  }

  double smallest_pivot_ratio() const override {
    if (size_ == 0) return 1;
    std::vector<double> pivots(static_cast<std::size_t>(size_));
    std::vector<Index> column(static_cast<std::size_t>(size_));
    Index reciprocal = 0;
    check(umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, column.data(),
                                 pivots.data(), &reciprocal, nullptr, numeric_.get()));
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < pivots.size(); ++j) {
      const double ratio = std::abs(pivots[j]) / column_scale_[column[j]];
      if (!(ratio >= smallest)) smallest = ratio;  // a NaN wins
    }
    return smallest;
  }

  std::int64_t factor_nonzeros() const override {
    if (size_ == 0) return 0;
    Index lower = 0, upper = 0, rows = 0, columns = 0, pivots = 0;
    check(umfpack_dl_get_lunz(&lower, &upper, &rows, &columns, &pivots, numeric_.get()));
    return lower + upper - size_;  // L has ones on its diagonal
  }

 private:
  void analyse(const SparseMatrix& matrix) {
    if (pattern_.matches(matrix)) return;
    pattern_.assign(matrix);
    const Index status = umfpack_dl_symbolic(size_, size_, pattern_.column_start().data(), pattern_.rows().data(),
                                             matrix.valuePtr(), symbolic_.slot(), control_.data(), nullptr);
    if (status < 0) pattern_.clear();
    check(status);
    integer_work_.resize(static_cast<std::size_t>(size_));
    real_work_.resize(static_cast<std::size_t>(size_));
  }

  std::array<double, UMFPACK_CONTROL> control_ = {};
  SparsityPattern<Index> pattern_;  // what `symbolic_` was made for
  UmfpackHandle<umfpack_dl_free_symbolic> symbolic_;
  UmfpackHandle<umfpack_dl_free_numeric> numeric_;
  Eigen::Index size_ = 0;
  Eigen::VectorXd column_scale_;  // largest entry of every column after row scaling
  mutable std::vector<Index> integer_work_;
  mutable std::vector<double> real_work_;
  bool has_factor_ = false;
};

}  // namespace

std::unique_ptr<SparseLU> make_sparse_lu() { return std::make_unique<SuiteSparseLU>(); }

}  // namespace bempd::linalg

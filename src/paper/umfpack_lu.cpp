#include <umfpack.h>

#include <Eigen/UmfPackSupport>
#include <new>
#include <stdexcept>
#include <string>

#include "linalg/expected_time.hpp"
#include "paper/row_scaled_lu.hpp"
#include "paper/sparse_lu.hpp"
#include "phase.hpp"

namespace bempd::paper {

namespace {

// UMFPACK counts the memory of a factor in the integer type of its indices. This type has 64 bits here, because 32 bits
// would limit the factor.
using LongMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;
static_assert(sizeof(SuiteSparse_long) == 8);

class Umfpack : public Eigen::UmfPackLU<LongMatrix> {
 public:
  Umfpack() {
    m_control[UMFPACK_IRSTEP] = 0;
    m_control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
    // AMD is the only ordering: METIS reseeds the process-wide random generator and swaps signal handlers.
    m_control[UMFPACK_ORDERING] = UMFPACK_ORDERING_AMD;
  }

  void analyzePattern(const LongMatrix& matrix) {
    UmfPackLU::analyzePattern(matrix);
    check(m_fact_errorCode);
  }
  // UMFPACK cannot be cancelled, so the duration is estimated in advance. The estimate uses UMFPACK's own bound on the
  // number of operations, which is 4 to 10 times the true number.
  void factorize(const LongMatrix& matrix) {
    const Phase phase("sparse factorization", 1,
                      linalg::expected_time_of_products(m_umfpackInfo[UMFPACK_FLOPS_ESTIMATE]));
    UmfPackLU::factorize(matrix);
    check(m_fact_errorCode);
  }

  // Solves A x = rhs. Eigen's own function is not used, because it returns uninitialized memory after a failure of
  // UMFPACK.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& rhs) const {
    Eigen::MatrixXd x(rhs.rows(), rhs.cols());
    for (Eigen::Index c = 0; c < rhs.cols(); ++c) {
      check(umfpack_dl_solve(UMFPACK_A, mp_matrix.outerIndexPtr(), mp_matrix.innerIndexPtr(), mp_matrix.valuePtr(),
                             x.col(c).data(), rhs.col(c).data(), m_numeric, m_control.data(), nullptr));
    }
    return x;
  }

  Eigen::VectorXd pivots() const {
    Eigen::VectorXd diagonal(cols()), by_column(cols());
    Eigen::VectorX<SuiteSparse_long> column(cols());
    SuiteSparse_long reciprocal = 0;
    check(umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, column.data(),
                                 diagonal.data(), &reciprocal, nullptr, m_numeric));
    by_column(column) = diagonal;
    return by_column;
  }

  std::int64_t entries() const {
    SuiteSparse_long lower = 0, upper = 0, rows = 0, columns = 0, pivots = 0;
    umfpack_dl_get_lunz(&lower, &upper, &rows, &columns, &pivots, m_numeric);
    return lower + upper - rows;  // L has ones on its diagonal
  }

 private:
  // Throws for a negative code of UMFPACK, which is an error; positive codes are warnings.
  static void check(SuiteSparse_long code) {
    if (code == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    if (code < 0) throw std::runtime_error("UMFPACK: error " + std::to_string(code));
  }
};

}  // namespace

std::unique_ptr<linalg::SparseFactorization> make_sparse_lu() { return std::make_unique<RowScaledLU<Umfpack>>(); }

}  // namespace bempd::paper

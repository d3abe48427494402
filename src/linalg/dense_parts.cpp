#include "linalg/dense_parts.hpp"

#include "linalg/expected_time.hpp"
#include "phase.hpp"

namespace bempd::linalg {

namespace {

constexpr Eigen::Index width = 256;  // columns of a panel

using Matrix = Eigen::Ref<Eigen::MatrixXd>;
using Lower = Eigen::Ref<const Eigen::MatrixXd>;

double operations(const Lower& lower, Eigen::Index vectors) {
  return static_cast<double>(lower.rows()) * static_cast<double>(lower.rows()) * static_cast<double>(vectors);
}

}  // namespace

void add_product(Matrix c, const Operand& a, const Operand& b, double factor) {
  constexpr Eigen::Index widest = 512;
  const double inner = 2.0 * static_cast<double>(a.cols());
  const bool in_parts = is_long(inner * static_cast<double>(c.size()));
  const Eigen::Index across = in_parts ? widest : c.cols();
  const Eigen::Index down =
      in_parts ? std::max<Eigen::Index>(64, static_cast<Eigen::Index>(operations_at_once / inner) / widest) : c.rows();
  for (Eigen::Index j = 0; j < c.cols(); j += across) {
    const Eigen::Index columns = std::min(across, c.cols() - j);
    const Operand right = b.transpose().middle_rows(j, columns).transpose();
    for (Eigen::Index i = 0; i < c.rows(); i += down) {
      const Eigen::Index rows = std::min(down, c.rows() - i);
      if (in_parts) check_cancelled();
      a.middle_rows(i, rows).as_matrix([&](const auto& left) {
        right.as_matrix([&](const auto& other) { c.block(i, j, rows, columns).noalias() += factor * (left * other); });
      });
    }
  }
}

void add_square(Matrix c, const Operand& a, double factor) {
  if (a.cols() == 0) return;  // Eigen divides by the number of columns
  const auto n = static_cast<double>(c.rows());
  const bool in_parts = is_long(n * n * static_cast<double>(a.cols()));
  const Eigen::Index across = in_parts ? width : c.rows();
  for (Eigen::Index j = 0; j < c.rows(); j += across) {
    const Eigen::Index columns = std::min(across, c.rows() - j), below = c.rows() - j - columns;
    if (in_parts) check_cancelled();
    const Operand own = a.middle_rows(j, columns);
    own.as_matrix([&](const auto& part) {
      c.block(j, j, columns, columns).selfadjointView<Eigen::Lower>().rankUpdate(part, factor);
    });
    if (below == 0) continue;
    add_product(c.bottomRows(below).middleCols(j, columns), a.middle_rows(j + columns, below), own.transpose(), factor);
  }
}

void solve_lower(const Lower& lower, Matrix x) {
  const Eigen::Index n = lower.rows();
  if (!is_long(operations(lower, x.cols()))) {
    lower.triangularView<Eigen::Lower>().solveInPlace(x);
    return;
  }
  for (Eigen::Index j = 0; j < n; j += width) {
    const Eigen::Index rows = std::min(width, n - j), below = n - j - rows;
    check_cancelled();
    lower.block(j, j, rows, rows).triangularView<Eigen::Lower>().solveInPlace(x.middleRows(j, rows));
    add_product(x.bottomRows(below), lower.block(j + rows, j, below, rows), x.middleRows(j, rows), -1);
  }
}

void solve_upper(const Lower& lower, Matrix x) {
  const Eigen::Index n = lower.rows();
  if (!is_long(operations(lower, x.cols()))) {
    lower.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
    return;
  }
  for (Eigen::Index end = n; end > 0;) {
    const Eigen::Index rows = std::min(width, end), j = end - rows;
    check_cancelled();
    lower.block(j, j, rows, rows).transpose().triangularView<Eigen::Upper>().solveInPlace(x.middleRows(j, rows));
    add_product(x.topRows(j), lower.block(j, 0, rows, j).transpose(), x.middleRows(j, rows), -1);
    end = j;
  }
}

void solve_upper_from_right(const Lower& lower, Matrix x) {
  const Eigen::Index n = lower.rows();
  if (!is_long(operations(lower, x.rows()))) {
    lower.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(x);
    return;
  }
  for (Eigen::Index j = 0; j < n; j += width) {
    const Eigen::Index columns = std::min(width, n - j);
    auto own = x.middleCols(j, columns);
    add_product(own, x.leftCols(j), lower.block(j, 0, columns, j).transpose(), -1);
    check_cancelled();
    lower.block(j, j, columns, columns).transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(own);
  }
}

bool factorize_in_parts(Matrix lower) {
  const Eigen::Index n = lower.rows();
  const auto done = [n](Eigen::Index j) {  // share of the work done after j columns
    const double part = static_cast<double>(j) / static_cast<double>(n);
    return part * part * (3 - 2 * part);
  };
  const double size = static_cast<double>(n);
  const Phase phase("dense factorization", 1, expected_time_of_products(size * size * size / 3));
  for (Eigen::Index j = 0; j < n; j += width) {
    const Eigen::Index columns = std::min(width, n - j), below = n - j - columns;
    check_cancelled();
    phase.reach(done(j));
    Matrix own = lower.block(j, j, columns, columns);
    if (j > 0) own.selfadjointView<Eigen::Lower>().rankUpdate(lower.block(j, 0, columns, j), -1);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(own);
    if (factor.info() != Eigen::Success) return false;
    if (below == 0) break;  // some BLAS print a complaint about empty matrices
    add_product(lower.block(j + columns, j, below, columns), lower.block(j + columns, 0, below, j),
                lower.block(j, 0, columns, j).transpose(), -1);
    solve_upper_from_right(own, lower.block(j + columns, j, below, columns));
  }
  return true;
}

void DenseCholesky::compute(Eigen::MatrixXd matrix) {
  m_isInitialized = false;
  m_matrix = std::move(matrix);
  // The norm is the largest column sum of magnitudes, as Eigen uses it to estimate the condition.
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(m_matrix.rows());
  for (Eigen::Index j = 0; j < m_matrix.cols(); ++j) {
    const auto below = m_matrix.col(j).tail(m_matrix.rows() - j).cwiseAbs();
    sums[j] += below.sum();
    sums.tail(m_matrix.rows() - j - 1) += below.tail(below.size() - 1);
  }
  m_l1_norm = sums.size() > 0 ? sums.maxCoeff() : 0;
  const bool positive = is_long(operations(m_matrix, m_matrix.rows()) / 3)
                            ? factorize_in_parts(m_matrix)
                            : Eigen::internal::llt_inplace<double, Eigen::Lower>::blocked(m_matrix) < 0;
  m_info = positive ? Eigen::Success : Eigen::NumericalIssue;
  m_isInitialized = true;
}

// Factorizes by blocked elimination as Eigen's own method does (its PartialPivLU.h), but does long products in parts.
void DenseLU::compute(Eigen::MatrixXd matrix) {
  const Eigen::Index n = matrix.rows();
  if (!is_long(operations(matrix, n) * 2 / 3)) {
    PartialPivLU::compute(matrix);
    return;
  }
  m_isInitialized = false;
  m_lu = std::move(matrix);
  m_l1_norm = m_lu.cwiseAbs().colwise().sum().maxCoeff();
  m_rowsTranspositions.resize(n);
  int swaps = 0;
  for (Eigen::Index k = 0; k < n; k += width) {
    check_cancelled();
    const Eigen::Index columns = std::min(width, n - k), behind = n - k - columns;
    Matrix panel = m_lu.block(k, k, n - k, columns);
    Eigen::Transpositions<Eigen::Dynamic> own(columns);
    int own_swaps = 0;
    Eigen::internal::partial_lu_inplace(panel, own, own_swaps);
    swaps += own_swaps;
    for (Eigen::Index i = 0; i < columns; ++i) {
      const Eigen::Index pivot = k + own.coeff(i);
      m_rowsTranspositions.coeffRef(k + i) = static_cast<int>(pivot);
      m_lu.row(k + i).head(k).swap(m_lu.row(pivot).head(k));
      m_lu.row(k + i).tail(behind).swap(m_lu.row(pivot).tail(behind));
    }
    Matrix right = m_lu.block(k, k + columns, columns, behind);
    m_lu.block(k, k, columns, columns).triangularView<Eigen::UnitLower>().solveInPlace(right);
    add_product(m_lu.bottomRightCorner(behind, behind), m_lu.block(k + columns, k, behind, columns), right, -1);
  }
  m_det_p = swaps % 2 != 0 ? -1 : 1;
  m_p = m_rowsTranspositions;
  m_isInitialized = true;
}

}  // namespace bempd::linalg

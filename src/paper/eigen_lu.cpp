#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <new>

#include "paper/row_scaled_lu.hpp"
#include "paper/sparse_lu.hpp"

namespace bempd::paper {

namespace {

// Sparse matrix with 64-bit indices: Eigen counts the entries of the factor in the index type, and 32 bits would
// overflow without notice.
using LongMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

// Minimum degree ordering of A + A^T for Eigen's LU, which needs the new place of each old column. Eigen's ordering
// returns the old place of each new column.
struct MinimumDegree {
  using PermutationType = Eigen::AMDOrdering<std::int64_t>::PermutationType;
  void operator()(const LongMatrix& matrix, PermutationType& permutation) const {
    PermutationType order;
    Eigen::AMDOrdering<std::int64_t>()(matrix, order);
    permutation = order.inverse();
  }
};

class Supernodal : public Eigen::SparseLU<LongMatrix, MinimumDegree> {
 public:
  Supernodal() {
    // Symmetric mode is chosen because the systems have a symmetric pattern and usually a good diagonal. The mode
    // orders by the pattern of A + A^T and keeps a diagonal pivot that is not much smaller than the best pivot, which
    // gives far less fill than full partial pivoting.
    isSymmetric(true);
    setPivotThreshold(0.1);
  }

  void factorize(const LongMatrix& matrix) {
    SparseLU::factorize(matrix);
    // Eigen reports missing memory as a numerical issue, like a singular matrix. Only the message tells which of the
    // two it is.
    if (info() != Eigen::Success && lastErrorMessage().starts_with("UNABLE TO")) throw std::bad_alloc();
  }

  Eigen::VectorXd pivots() const {
    Eigen::VectorXd by_column(cols());
    for (Eigen::Index j = 0; j < cols(); ++j) by_column[j] = pivot(colsPermutation().indices()[j]);
    return by_column;
  }

  std::int64_t entries() const {
    Supernodal& self = const_cast<Supernodal&>(*this);  // counting is not const in Eigen 3.4
    return self.nnzL() + self.nnzU() - cols();          // L has ones on its diagonal
  }

 private:
  // Pivot number j. The diagonal blocks of U are stored with L, whose rows have no particular order.
  double pivot(Eigen::Index j) const {
    for (SCMatrix::InnerIterator it(m_Lstore, j); it; ++it)
      if (it.row() == j) return it.value();
    return 0;
  }
};

}  // namespace

std::unique_ptr<linalg::SparseFactorization> make_sparse_lu() { return std::make_unique<RowScaledLU<Supernodal>>(); }

}  // namespace bempd::paper

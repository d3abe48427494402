#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <new>

#include "paper/row_scaled_lu.hpp"
#include "paper/sparse_lu.hpp"

namespace bempd::paper {

namespace {

// Matrix with 64-bit indices: Eigen counts the entries of the factor in the index type, and 32 bits would overflow
// without notice.
using LongMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

// Minimum degree ordering of A + A^T. Eigen's own returns the old place of a new column, but its LU needs the new place
// of an old one.
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
    // Symmetric mode, because the systems have a symmetric pattern and usually a good diagonal: an ordering for the
    // pattern of A + A^T, which keeps a diagonal pivot that is not much smaller than the best one, has far less fill
    // than full partial pivoting.
    isSymmetric(true);
    setPivotThreshold(0.1);
  }

  void factorize(const LongMatrix& matrix) {
    SparseLU::factorize(matrix);
    // Eigen reports both a singular matrix and memory that ran out as a numerical issue.
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
  // Pivot j; U's diagonal blocks are stored with L, whose rows have no particular order.
  double pivot(Eigen::Index j) const {
    for (SCMatrix::InnerIterator it(m_Lstore, j); it; ++it)
      if (it.row() == j) return it.value();
    return 0;
  }
};

}  // namespace

std::unique_ptr<linalg::SparseFactorization> make_sparse_lu() { return std::make_unique<RowScaledLU<Supernodal>>(); }

}  // namespace bempd::paper

#include "linalg/sparse_cholesky.hpp"

#include "error.hpp"
#include "linalg/external_cholesky.hpp"

namespace bempd::linalg {

Eigen::MatrixXd SparseCholesky::eliminated_products(const Eigen::MatrixXd& a, const TwoColumns& b, int known) const {
  const Eigen::Index others = a.rows() - known;
  return a.topRows(others).transpose() * b.topRows(others);
}

std::unique_ptr<SparseCholesky> make_sparse_cholesky() {
  const SolverChoice* const choice = SolverScope::current();
  if (!choice) return own_cholesky(false);
  if (choice->external) return external_cholesky(choice->external, choice->scratch);
  if (!choice->scratch.empty())
    fail(Failure::order, "linalg.scratch is '", choice->scratch,
         "', but the library's own factorization works in memory; attach MUMPS by bempd_mpi_attach() before the first "
         "step, or leave the option empty");
  return own_cholesky(choice->wide_indices);
}

}  // namespace bempd::linalg

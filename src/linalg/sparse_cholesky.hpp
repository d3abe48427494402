#pragma once

#include <memory>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Cholesky factor of a symmetric positive definite matrix: factorize() takes the lower triangle and refuses a matrix
// that is not positive definite. Pivot ratios are taken to the diagonal entries.
//
// After a removal to a singular matrix the factor stays finite, with the lost pivots kept at `singular_pivot_ratio` of
// the largest diagonal entry; smallest_pivot_ratio() tells.
class SparseCholesky : public SparseFactorization {};

std::unique_ptr<SparseCholesky> make_sparse_cholesky();

}  // namespace bempd::linalg

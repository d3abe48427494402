#pragma once

#include <memory>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Factor P R A Q = L U of a matrix that need not be symmetric: factorize() takes all of it. R divides every row by its
// largest entry, so that rows may have different units; P and Q reorder. The pivot ratio is the smallest |U_jj| over
// the largest entry of that column of R A. A change always leaves the factor stale.
class SparseLU : public SparseFactorization {};

std::unique_ptr<SparseLU> make_sparse_lu();

}  // namespace bempd::linalg

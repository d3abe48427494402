#pragma once

#include <memory>

#include "linalg/sparse_factorization.hpp"

namespace bempd::paper {

// Factor P R A Q = L U of a sparse matrix that need not be symmetric; factorize() reads the whole matrix. R divides
// every row by its largest entry, so that rows may have different units; P and Q reorder. The pivot ratio is the
// smallest ratio of |U_jj| to the largest entry of its column of R A. The factor has no low-rank changes: update()
// leaves it stale.
std::unique_ptr<linalg::SparseFactorization> make_sparse_lu();

}  // namespace bempd::paper

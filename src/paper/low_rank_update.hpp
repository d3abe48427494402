#pragma once

#include <memory>

#include "linalg/sparse_factorization.hpp"

namespace bempd::paper {

// Adds low-rank changes to a factorization that has none. For the changed matrix A + C S C^T, where S is diagonal with
// entries +-1, the formula of Sherman, Morrison and Woodbury is used, with Z = A^-1 C:
//   (A + C S C^T)^-1 = A^-1 - Z (S + C^T Z)^-1 C^T A^-1.
// Every changed column takes one solution and one stored vector. After `most_columns` columns (fewer if memory would
// not suffice) the factor is left stale. The pivot ratio also counts the pivots of S + C^T Z, which vanish if a removal
// leaves a singular matrix.
std::unique_ptr<linalg::SparseFactorization> with_low_rank_updates(
    std::unique_ptr<linalg::SparseFactorization> factorization, int most_columns);

}  // namespace bempd::paper

#pragma once

#include <memory>
#include <string>

#include "linalg/external_solver.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::linalg {

// Cholesky factor by a solver from outside the library. The solver eliminates all unknowns but the kept ones. The Schur
// complement on the kept unknowns is factorized here, and low-rank changes are stored beside the factor
// (low_rank_change.hpp).
std::unique_ptr<SparseCholesky> external_cholesky(std::shared_ptr<ExternalSolver> solver, std::string scratch);

}  // namespace bempd::linalg

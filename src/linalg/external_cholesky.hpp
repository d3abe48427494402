#pragma once

#include <memory>
#include <string>

#include "linalg/external_solver.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::linalg {

// Cholesky factor by a solver from outside the library. The solver eliminates all unknowns but the kept ones; the Schur
// complement on these is factorized here. There are no changes of low rank: every update() leaves a stale factor.
std::unique_ptr<SparseCholesky> external_cholesky(std::shared_ptr<ExternalSolver> solver, std::string scratch);

}  // namespace bempd::linalg

#pragma once

#include "coupling/solution_method.hpp"

namespace bempd::coupling {

// LU factors and GMRES, for matrices that need not be symmetric.
const SolutionMethod& unsymmetric_solution();

}  // namespace bempd::coupling

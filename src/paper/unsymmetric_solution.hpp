#pragma once

#include "coupling/solution_method.hpp"

namespace bempd::paper {

// Method with LU factors and iterative refinement, for matrices that need not be symmetric.
const coupling::SolutionMethod& unsymmetric_solution();

}  // namespace bempd::paper

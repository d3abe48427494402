#pragma once

#include "coupling/solution_method.hpp"

namespace bempd::paper {

// Solution method for matrices that need not be symmetric: LU factors and iterative refinement.
const coupling::SolutionMethod& unsymmetric_solution();

}  // namespace bempd::paper

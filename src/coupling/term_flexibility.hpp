#pragma once

#include <Eigen/Core>
#include <span>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// F = B^T K^-1 B: what terms lengthen by under unit pulls along each of them, in the body as it is [m/N]. Uses the
// system's factor, or makes one where there is none of the present matrix.
Eigen::MatrixXd flexibility_of(EquilibriumSystem& system, std::span<const int> terms);

// Flexibility by a factor of its own, where the system's factor belongs to another matrix or must stay as it is.
Eigen::MatrixXd flexibility_apart(const EquilibriumSystem& system, std::span<const int> terms);

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Core>
#include <span>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Flexibility matrix F = B^T K^-1 B of terms [m/N]: F_ij is the elongation of term i in the present body under unit
// pulls along term j. Uses the system's factor, or makes one if there is none of the present matrix.
Eigen::MatrixXd flexibility_of(EquilibriumSystem& system, std::span<const int> terms);

// Flexibility matrix of terms by a separate factor, for systems whose factor belongs to another matrix or must stay as
// it is.
Eigen::MatrixXd flexibility_apart(const EquilibriumSystem& system, std::span<const int> terms);

}  // namespace bempd::coupling

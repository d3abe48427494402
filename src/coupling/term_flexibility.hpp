#pragma once

#include <Eigen/Core>
#include <span>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Flexibility matrix F = B^T K^-1 B of energy terms (bonds or cell squares) [m/N], where K is the stiffness matrix and
// a column of B has the nodal forces of unit tension in a term: F_ij is the elongation of term i in the present body
// under unit tension along term j. The system's factor is used; if there is none of the present matrix, it is made
// first.
Eigen::MatrixXd flexibility_of(EquilibriumSystem& system, std::span<const int> terms);

// Flexibility matrix of terms as by flexibility_of(), but with a temporary factor of the present stiffness matrix. The
// system's own factor, which may belong to another matrix, is not changed.
Eigen::MatrixXd flexibility_by_temporary_factor(const EquilibriumSystem& system, std::span<const int> terms);

}  // namespace bempd::coupling

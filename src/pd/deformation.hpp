#pragma once

#include <Eigen/Core>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Displacement gradients du_i/dx_j at the material points: least-squares fits over each point's intact bonds, weighted
// with one over the squared bond length, exact for linear fields wherever the bonds span the plane. What a point's
// bonds cannot see (a direction across them all) counts as not deformed. Displacements are numbered 2 * point +
// component, in units of the spacing.
std::vector<Eigen::Matrix2d> displacement_gradients(const CellLattice& lattice, const std::vector<Bond>& bonds,
                                                    const std::vector<char>& intact,
                                                    const Eigen::VectorXd& displacement);

// Stress xx, yy, xy of the undamaged material under these gradients, one column per material point [Pa].
Eigen::Matrix3Xd point_stresses(const CellLattice& lattice, const std::vector<Bond>& bonds,
                                const std::vector<char>& intact, const Eigen::VectorXd& displacement,
                                const PlaneElasticity& elasticity);

}  // namespace bempd::pd

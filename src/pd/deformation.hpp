#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Displacement gradient du_k/dx_l at every material point: weighted least squares over the bonds that are intact, exact
// for linear fields everywhere. `broken` holds one entry a bond (nonzero: broken) or is empty; `displacements` the
// components of point i in 2 i and 2 i + 1; x is in lattice units, the caller divides by the spacing. Where the intact
// bonds lie on one line only the stretch and the rotation of that line are known and the rest is taken as rigid; a
// point without intact bonds has no gradient and gets zero.
std::vector<Eigen::Matrix2d> displacement_gradients(int point_count, const Network& network,
                                                    const std::vector<std::uint8_t>& broken,
                                                    const Eigen::Ref<const Eigen::VectorXd>& displacements);

// Stresses (xx, yy, xy) of the symmetric part of a displacement gradient.
Eigen::Vector3d stress_of(const Eigen::Matrix2d& gradient, const PlaneElasticity& elasticity);

}  // namespace bempd::pd

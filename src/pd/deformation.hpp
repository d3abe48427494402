#pragma once

#include <Eigen/Core>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// States of bonds, one entry a bond: the share of its stiffness that is left (0 if it is broken or cut), and the
// stretch at which it carries no force. Empty vectors mean 1 and 0 everywhere.
struct BondStates {
  std::vector<double> share, rest_stretch;
};

// Strains (xx, yy, xy) at every material point, from its bond forces. With f the force in a bond, xi the bond from end
// to end and both halves of it at their own points,
//   sum f xi^T  over all bonds  =  (sum k xi xi^T xi xi^T / |xi|^2  over all bonds, intact stiffness k) : strain.
// Far from faces the sum on the right is twice the volume of a cell times the elastic constants, and the stress of this
// strain is the mean stress of the bonds, sum f xi^T / (2 V) (Silling and Lehoucq, J. Elasticity 93, 2008). At faces
// the right-hand side has the point's fewer bonds, so that linear displacements have their strain everywhere. Bonds of
// such points lie on one side: the strain is taken to vary linearly along them, unless some are broken or softened or
// there are too few. A broken bond carries no force: a point without intact bonds has no stress. `displacements`:
// components of point i in 2 i and 2 i + 1, over the spacing.
std::vector<Eigen::Vector3d> bond_strains(int point_count, const Network& network, const BondStates& states,
                                          const Eigen::Ref<const Eigen::VectorXd>& displacements);

// Stresses (xx, yy, xy) of strains.
Eigen::Vector3d stress_of(const Eigen::Vector3d& strain, const PlaneElasticity& elasticity);

}  // namespace bempd::pd

#pragma once

#include <Eigen/Core>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// States of bonds, one entry for each bond: the share of the bond's stiffness that is left (0 if the bond is broken or
// cut), and the stretch at which it carries no force. Empty vectors mean 1 and 0 everywhere.
struct BondStates {
  std::vector<double> share, rest_stretch;
};

// Strains (xx, yy, xy) at every material point, from the forces in its bonds. A bond has the force vector f and the
// stiffness k when intact, and xi is the vector from one of its ends to the other. Half of each bond belongs to each of
// its two points, so that the strain e of a point solves
//   sum of f xi^T over all bonds  =  (sum of k xi xi^T xi xi^T / |xi|^2 over all bonds) : e.
// Far from faces the sum on the right is twice the volume V of a cell times the elastic constants. The stress of the
// strain is then the mean stress of the bonds, the sum of f xi^T / (2 V) (Silling and Lehoucq, J. Elasticity 93, 2008).
// At faces both sums have only the bonds that the point has, so that linear displacements give their exact strain
// everywhere. Because the bonds of a point at a face lie on one side of the point, the strain is taken to vary linearly
// along them, unless bonds of the point are broken, softened or too few. A broken bond carries no force; a point
// without intact bonds has no stress. `displacements` are divided by the spacing; the components of point i are at 2 i
// and 2 i + 1.
std::vector<Eigen::Vector3d> bond_strains(int point_count, const Network& network, const BondStates& states,
                                          const Eigen::Ref<const Eigen::VectorXd>& displacements);

// Stress (xx, yy, xy) of a strain (xx, yy, xy) by Hooke's law.
Eigen::Vector3d stress_of(const Eigen::Vector3d& strain, const PlaneElasticity& elasticity);

}  // namespace bempd::pd

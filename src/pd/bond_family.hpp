#pragma once

#include <Eigen/Core>
#include <vector>

#include "pd/bond_kernel.hpp"

namespace bempd::pd {

// Vector of a bond in units of the spacing, with the quantities that loops over bonds need.
struct BondOffset {
  Eigen::Vector2d step = {0, 0};  // whole numbers between points of a lattice
  double length = 0;
  Eigen::Vector2d direction = {0, 0};
  double bulk_stiffness = 0;              // far from all faces, for C1111 = 1 and thickness 1
  Eigen::Vector4d moment = {0, 0, 0, 0};  // length * direction^3, components 111, 112, 122, 222
};

// Half of the family of bonds of a material point: every pair of points closer than `horizon_ratio` spacings appears
// once, as the step from its lower end (its left end if both are level), sorted by row and then by column of the step.
// Squared lengths are compared as integers. A bond as long as the horizon is left out, because its stiffness is 0.
//
// Stiffnesses come from the kernel's micromodulus, and are then changed by the least relative amounts that give the
// lattice the elastic constants C1111 = 1, C1122 = C1212 = 1/3 exactly.
std::vector<BondOffset> bond_family(int horizon_ratio, const BondKernel& kernel = quartic_kernel());

// Stiffness of a bond of this length between two full cells by the kernel alone, before bond_family() corrects it, for
// C1111 = 1 and thickness 1.
double kernel_stiffness(const BondKernel& kernel, double length, double horizon);

}  // namespace bempd::pd

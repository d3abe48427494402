#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Derivatives of the displacement along the boundary at the start and the end of every element, each from the five
// nodes of two neighbouring elements of a panel. The interpolation is trigonometric on arcs and polynomial on straight
// pieces. Within a panel the slopes are continuous and of fourth order, two orders more than those of the shape
// functions. A slope is not known if the panel has one element only, if a mid node lies off the middle of its element,
// or at an end of a panel whose last two elements differ in length by more than a factor of two.
struct ElementSlopes {
  std::array<bool, 2> known{};
  std::array<Point, 2> slope;
};
std::vector<ElementSlopes> boundary_slopes(const BoundaryMesh& mesh, const Eigen::VectorXd& displacements);

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Derivative of the displacement along the boundary at the start and the end of every element, from the five nodes of
// the two elements that meet there. Interpolation is trigonometric on arcs, else polynomial. Slopes are continuous
// inside panels and of fourth order, two orders more than those of the shape functions. They are unknown where a panel
// has one element, or where the neighbour beyond the end of the panel differs too much in size.
struct ElementSlopes {
  std::array<bool, 2> known{};
  std::array<Point, 2> slope;
};
std::vector<ElementSlopes> boundary_slopes(const BoundaryMesh& mesh, const Eigen::VectorXd& displacements);

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Derivatives of the displacement along the boundary at the start and the end of every element, from the five nodes of
// the two elements that meet there. The interpolation is trigonometric on arcs, else polynomial. Within a panel the
// slopes are continuous and of fourth order, two orders more than those of the shape functions. Unknown where a panel
// has one element only, or where the two elements at the end of a panel differ too much in length.
struct ElementSlopes {
  std::array<bool, 2> known{};
  std::array<Point, 2> slope;
};
std::vector<ElementSlopes> boundary_slopes(const BoundaryMesh& mesh, const Eigen::VectorXd& displacements);

}  // namespace bempd::bem

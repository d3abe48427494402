#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Derivative of the displacement along the boundary at the start and the end of every element, from the five nodes of
// the two elements around: on arcs as trigonometric, else as polynomial interpolation has it. Slopes are continuous
// inside panels and of fourth order, two orders more than those of the elements' own functions. Nothing where a panel
// has one element or the neighbours' sizes differ too much to look across the end of the panel.
struct ElementSlopes {
  std::array<bool, 2> known{};
  std::array<Point, 2> slope;
};
std::vector<ElementSlopes> boundary_slopes(const BoundaryMesh& mesh, const Eigen::VectorXd& displacements);

}  // namespace bempd::bem

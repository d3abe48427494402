#pragma once

#include <Eigen/Core>
#include <functional>

#include "bem/crack_mesh.hpp"

namespace bempd::bem {

// Traction [Pa] on the left face of line `line` at a place with the given outward normal of that face; the right face
// has the opposite traction.
using FaceTraction = std::function<Point(int line, const Point& x, const Point& normal)>;

// Forces [N] on all openings, numbered 2 * node + component.
Eigen::VectorXd crack_forces(const CrackMesh& cracks, const FaceTraction& traction, double thickness);

// Adds forces [N] on the boundary's nodes, numbered 2 * node + component, of such tractions on the faces of lines that
// cut the body.
void add_forces_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks, const FaceTraction& traction,
                        double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Work of the tractions on one tip's element, over thickness, per length of growth of that tip. The nodal openings of
// the element stay the same, and its far node does not move.
double work_of_growth(const CrackMesh& cracks, const CrackTip& tip, const FaceTraction& traction,
                      const Eigen::VectorXd& openings);

}  // namespace bempd::bem

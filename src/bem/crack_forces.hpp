#pragma once

#include <Eigen/Core>
#include <functional>

#include "bem/crack_mesh.hpp"

namespace bempd::bem {

// Traction [Pa] on the left face of line `line` at a place whose outward normal of that face is given; the right face
// has the opposite one.
using FaceTraction = std::function<Point(int line, const Point& x, const Point& normal)>;

// Forces [N] on all openings, numbered 2 * node + component.
Eigen::VectorXd crack_forces(const CrackMesh& cracks, const FaceTraction& traction, double thickness);

// Adds forces [N] on the boundary's nodes, numbered likewise, of the same on the faces between pieces.
void add_forces_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks, const FaceTraction& traction,
                        double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Work over thickness of the tractions on one tip's element per length by which it grows, its openings staying as they
// are at its nodes, of which the far one does not move.
double work_of_growth(const CrackMesh& cracks, const CrackTip& tip, const FaceTraction& traction,
                      const Eigen::VectorXd& openings);

}  // namespace bempd::bem

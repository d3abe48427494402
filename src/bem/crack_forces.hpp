#pragma once

#include <Eigen/Core>
#include <functional>

#include "bem/crack_mesh.hpp"

namespace bempd::bem {

// Traction [Pa] on the left face of crack line `line` at the place x, where `normal` is the outward normal of that
// face. The right face has the opposite traction.
using FaceTraction = std::function<Point(int line, const Point& x, const Point& normal)>;

// Forces [N] that act on the openings under tractions on the crack faces, numbered 2 * node + component over all
// opening nodes.
Eigen::VectorXd crack_forces(const CrackMesh& cracks, const FaceTraction& traction, double thickness);

// Adds the forces [N] of tractions on the faces of the crack lines that cut the body into pieces. These forces act on
// boundary nodes and are numbered 2 * node + component.
void add_forces_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks, const FaceTraction& traction,
                        double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Work per thickness of the face tractions on a tip's element, differentiated by the length by which the tip grows. The
// element's nodal openings and the place of its other end are held.
double work_of_growth(const CrackMesh& cracks, const CrackTip& tip, const FaceTraction& traction,
                      const Eigen::VectorXd& openings);

}  // namespace bempd::bem

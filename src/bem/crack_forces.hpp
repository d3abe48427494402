#pragma once

#include <Eigen/Core>
#include <functional>

#include "bem/crack_mesh.hpp"

namespace bempd::bem {

// Traction [Pa] on the left face of line `line` at the place x, where `normal` is the outward normal of that face. The
// right face has the opposite traction.
using FaceTraction = std::function<Point(int line, const Point& x, const Point& normal)>;

// Forces [N] that act on the openings under tractions on the crack faces, numbered 2 * node + component over all
// opening nodes.
Eigen::VectorXd crack_forces(const CrackMesh& cracks, const FaceTraction& traction, double thickness);

// Adds the forces [N] of tractions on the faces of those lines that cut the body into pieces. They act on boundary
// nodes and are numbered 2 * node + component.
void add_forces_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks, const FaceTraction& traction,
                        double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Derivative, by the length of a tip's growth, of the work of face tractions on that tip's element, over thickness. The
// element's nodal openings and its far node are held.
double work_of_growth(const CrackMesh& cracks, const CrackTip& tip, const FaceTraction& traction,
                      const Eigen::VectorXd& openings);

}  // namespace bempd::bem

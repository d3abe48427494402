#pragma once

#include <Eigen/Core>
#include <functional>

#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Adds the consistent nodal forces thickness * integral of N_a t ds [N] of a traction t [Pa] on one panel, with the
// shape functions N_a of the nodes. `traction` gives t at the position of a quadrature point. Forces are numbered 2 *
// node + component.
void add_traction_forces(const BoundaryMesh& mesh, int panel, const std::function<Point(const Point&)>& traction,
                         double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Adds the consistent nodal forces [N] of a traction on one element; `tractions` [Pa] are its values at the three
// nodes.
void add_traction_forces(const BoundaryMesh& mesh, const BoundaryElement& element,
                         const Eigen::Matrix<double, 2, 3>& tractions, double thickness,
                         Eigen::Ref<Eigen::VectorXd> forces);

// Adds the consistent nodal forces of a stress field (xx, yy, xy) [Pa] along the whole boundary.
void add_stress_forces(const BoundaryMesh& mesh, const std::function<Eigen::Vector3d(const Point&)>& stress,
                       double thickness, Eigen::Ref<Eigen::VectorXd> forces);

// Adds the integrals of N_a n ds over the whole boundary, with the shape functions N_a of the nodes and the outward
// normal n, numbered 2 * node + component.
void add_normal_integrals(const BoundaryMesh& mesh, Eigen::Ref<Eigen::VectorXd> integrals);

// Integral over the area of a body of a function that is homogeneous of degree `degree` in the position relative to
// `centre`.
double integral_of_homogeneous(const BoundaryMesh& mesh, const Point& centre, int degree,
                               const std::function<double(const Point&)>& function);

}  // namespace bempd::bem

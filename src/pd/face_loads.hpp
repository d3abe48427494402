#pragma once

#include <Eigen/Core>
#include <functional>

#include "geometry/point.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Adds the consistent nodal forces of a traction on the straight piece from a to b of the lattice's boundary, in units
// of traction * thickness * spacing; a and b are any two places on one lattice line. Forces are numbered
// 2 * point + component; the traction is asked for at places in lattice coordinates. The shape functions are linear
// hats: sampling the traction at the material points would misjudge a parabolic shear by (spacing / height)^2.
void add_face_forces(const CellLattice& lattice, const Point& a, const Point& b,
                     const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces);

}  // namespace bempd::pd

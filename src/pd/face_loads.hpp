#pragma once

#include <Eigen/Core>
#include <functional>

#include "geometry/point.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Adds the nodal forces of a traction on the straight piece of boundary from a to b, which lies on one lattice line and
// may begin and end anywhere: f_i = integral of phi_i t ds with linear hats phi_i, four Gauss points for every (part of
// a) cell edge. All in lattice coordinates; the caller multiplies by spacing and thickness. `forces` holds the
// components of point i in 2 i and 2 i + 1.
void add_face_forces(const CellLattice& lattice, const Point& a, const Point& b,
                     const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces);

// The same for material points at the centres of cells (`centres` from CellLattice::centres_of): the force on every
// (part of a) cell edge goes whole to the point of the cell behind it, as a body force on the outermost layer (Yang and
// Liu 2021, Eq. 30). a and b are in the coordinates of the cells, not of their centres.
void add_layer_forces(const CellLattice& centres, const Point& a, const Point& b,
                      const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces);

}  // namespace bempd::pd

#pragma once

#include <Eigen/Core>
#include <functional>

#include "geometry/point.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::paper {

// Adds the forces of a traction on the piece of boundary from a to b to material points at the centres of cells
// (`centres` from CellLattice::centres_of). The force on every cell edge, or part of it, acts entirely on the point of
// the cell behind the edge, as a body force on the outermost layer (Yang and Liu 2021, Eq. 30). The coordinates a and b
// are those of the cells, not of their centres. (pd::add_face_forces does the same for points at the corners of cells.)
void add_layer_forces(const pd::CellLattice& centres, const Point& a, const Point& b,
                      const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces);

}  // namespace bempd::paper

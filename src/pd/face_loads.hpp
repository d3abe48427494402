#pragma once

#include <Eigen/Core>
#include <functional>

#include "geometry/point.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Function that is called with the force of a traction at a Gauss point of a cell edge. Its arguments are the lower end
// of the cell edge, the axis along the edge (0 for x, 1 for y), the fraction along the edge, and the force.
using CellEdgeVisitor =
    std::function<void(const Eigen::Vector2i& lower_end, int along, double fraction, const Point& force)>;
// Calls `visit` for the forces of a traction on the straight piece of boundary from a to b, at four Gauss points of
// every cell edge, or part of a cell edge, on the piece. The piece lies on one lattice line and may begin and end
// anywhere.
void for_forces_on_cell_edges(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                              const CellEdgeVisitor& visit);

// Adds the nodal forces of a traction on the straight piece of boundary from a to b, which lies on one lattice line:
// f_i = integral of phi_i t ds with linear hat functions phi_i. All is in lattice coordinates; the caller multiplies by
// spacing and thickness. `forces` holds the components of point i in 2 i and 2 i + 1.
void add_face_forces(const CellLattice& lattice, const Point& a, const Point& b,
                     const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces);

}  // namespace bempd::pd

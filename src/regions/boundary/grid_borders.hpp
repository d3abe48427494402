#pragma once

#include <vector>

#include "regions/boundary/boundary_meshing.hpp"

// Elements on interfaces with a region that has nodes at fixed places (grid points, or points on its outline). Pieces
// of such interfaces end at nodes of that region, or at the mouth of a crack half way between two such nodes.
namespace bempd::regions {

class OutlinedRegion;

// Throws Error (argument) if a piece of an interface ends neither at a grid point nor at a mouth in `mouths`.
void require_grid_ends(const Preparation& preparation, const Contact& contact, const Arc& piece,
                       const std::vector<Point>& mouths);

// Element ends on grid points along a piece of an interface, as fractions of the piece. `step` is 1 for elements of one
// spacing, 2 for elements of two spacings, whose mid nodes are grid points too.
std::vector<double> grid_stations(const Preparation& preparation, const Contact& contact, const Arc& piece, int step,
                                  const std::vector<Point>& mouths);

// Points on the neighbour's outline along a piece of an interface, including the ends of the piece.
std::vector<Point> points_of_neighbour(const Preparation& preparation, OutlinedRegion& other, const PanelSource& source,
                                       const Contact& contact, const Arc& piece, const std::vector<Point>& mouths);

}  // namespace bempd::regions

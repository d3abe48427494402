#pragma once

#include <vector>

#include "regions/boundary/boundary_meshing.hpp"

// Elements on interfaces whose other side has points at fixed places. Pieces of such interfaces end at these points, or
// at mouths of cracks, which lie half way between two of them.
namespace bempd::regions {

class OutlinedRegion;

// Throws Error (argument) for a piece that ends elsewhere.
void require_grid_ends(const Preparation& preparation, const Contact& contact, const Arc& piece,
                       const std::vector<Point>& mouths);

// Element ends on the points of a grid; `step` 2 if their middles are to be points too.
std::vector<double> grid_stations(const Preparation& preparation, const Contact& contact, const Arc& piece, int step,
                                  const std::vector<Point>& mouths);

// Points on the neighbour's outline along a piece, with the ends of the piece.
std::vector<Point> points_of_neighbour(const Preparation& preparation, OutlinedRegion& other, const PanelSource& source,
                                       const Contact& contact, const Arc& piece, const std::vector<Point>& mouths);

}  // namespace bempd::regions

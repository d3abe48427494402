#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::regions {

// Point that is added to a picture between some nodes. Its values are the means of the values at these nodes.
struct AddedPoint {
  Point place;
  std::vector<int> nodes;
};

// Quadrilateral cells for a picture, split where the bond between neighbouring nodes is broken, so that cracks appear
// open.
struct SplitCells {
  std::vector<AddedPoint> added;    // numbered after the region's nodes
  std::vector<std::int32_t> nodes;  // four for each cell, counter-clockwise
};

// Splits cells for a picture; `cells` holds four corners for each cell, counter-clockwise. A side of a cell is parted
// if the bond between the two ends of the side is broken; `parted` lists these pairs of nodes. Each piece of a split
// cell keeps the corners that intact sides connect, so a crack runs through the centres of cells and the middles of
// parted sides.
//
// Where a crack steps from one row of cells to the next, the bond along the step is intact. The side along the step is
// opened nevertheless if each of the two cells beside this side has exactly one parted side.
SplitCells split_cells(std::span<const Point> nodes, std::span<const std::int32_t> cells,
                       std::span<const std::array<int, 2>> parted);

}  // namespace bempd::regions

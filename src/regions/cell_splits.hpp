#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::regions {

// Point added to a picture in the middle of some nodes: its values are the means of the values of these nodes.
struct AddedPoint {
  Point place;
  std::vector<int> nodes;
};

// Quadrilateral cells for a picture, split where the bond between neighbouring nodes is broken, so that cracks appear
// open.
struct SplitCells {
  std::vector<AddedPoint> added;    // numbered after the nodes
  std::vector<std::int32_t> nodes;  // four a cell, counter-clockwise
};

// Splits cells for a picture. A side is parted if it is one of the pairs of nodes in `parted`: the bond between them is
// broken. Each piece of a cell keeps the corners that intact sides connect, so a crack runs through the centres of
// cells and the middles of parted sides.
// Where a crack steps from one row to the next, the bond along the step is not broken. That side is opened all the same
// if both cells beside it have one parted side each. `cells` holds four corners a cell, counter-clockwise.
SplitCells split_cells(std::span<const Point> nodes, std::span<const std::int32_t> cells,
                       std::span<const std::array<int, 2>> parted);

}  // namespace bempd::regions

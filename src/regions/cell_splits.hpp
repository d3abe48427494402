#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::regions {

// Point in the middle of some nodes: its values are the mean of theirs.
struct AddedPoint {
  Point place;
  std::vector<int> nodes;
};

// Four-cornered cells that open where bonds between neighbouring nodes are broken.
struct SplitCells {
  std::vector<AddedPoint> added;    // numbered after the nodes
  std::vector<std::int32_t> nodes;  // four a cell, counter-clockwise
};

// Splits cells with parted sides into pieces whose corners are connected by the sides that are left. So a crack runs
// from the middle of a cell through the middle of a side to the middle of the next cell. Where it steps sideways
// between two rows, the side along the step is not stretched and not parted: it opens with the two cells beside it that
// have one parted side each. `cells` holds the corners of cells, counter-clockwise, `parted` pairs of nodes.
SplitCells split_cells(std::span<const Point> nodes, std::span<const std::int32_t> cells,
                       std::span<const std::array<int, 2>> parted);

}  // namespace bempd::regions

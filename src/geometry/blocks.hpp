#pragma once

#include <array>
#include <functional>
#include <set>
#include <vector>

#include "geometry/edge.hpp"
#include "geometry/segment.hpp"

namespace bempd {

using Block = std::array<int, 2>;  // column, row
using Blocks = std::set<Block>;

// Grid of squares: block (i, j) reaches from origin + size * (i, j) to origin + size * (i + 1, j + 1).
struct BlockGrid {
  Point origin;
  double size;

  Point corner(int column, int row) const { return origin + size * Point(column, row); }
  Box box(const Block& block) const { return {corner(block[0], block[1]), corner(block[0] + 1, block[1] + 1)}; }
  // Blocks that come closer to a segment than `reach`.
  Blocks near(const Segment& segment, double reach) const;
};

double distance(const Box& box, const Segment& segment);

// Adds blocks so that none meet at a corner only, none are enclosed, and no two of a row or a column are one block
// apart. `may_add` says which blocks may be added. False if that leaves blocks that meet at a corner or are enclosed.
bool close_gaps(Blocks& blocks, const std::function<bool(const Block&)>& may_add);

// Parts that are connected by sides of blocks.
std::vector<Blocks> connected_parts(const Blocks& blocks);

// Outline of connected blocks without holes, counter-clockwise, with vertices at its corners only.
std::vector<Point> loop_around(const Blocks& blocks, const BlockGrid& grid);

}  // namespace bempd

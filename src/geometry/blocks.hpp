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

// Grid of square blocks of lattice cells: block (i, j) reaches from origin + size * (i, j) to origin + size * (i + 1, j
// + 1).
struct BlockGrid {
  Point origin;
  double size;

  Point corner(int column, int row) const { return origin + size * Point(column, row); }
  Box box(const Block& block) const { return {corner(block[0], block[1]), corner(block[0] + 1, block[1] + 1)}; }
  // Blocks whose distance to a segment is less than `reach`.
  Blocks near(const Segment& segment, double reach) const;
};

double distance(const Box& box, const Segment& segment);

// Adds blocks, among those for which may_add(block) is true, until no two blocks meet at a corner only, no missing
// block is enclosed, and no gap of one block is left in a row or a column. Returns false if blocks that meet at a
// corner only, or enclosed missing blocks, remain.
bool close_gaps(Blocks& blocks, const std::function<bool(const Block&)>& may_add);

// Parts of a set of blocks; the blocks of a part are connected by their sides.
std::vector<Blocks> connected_parts(const Blocks& blocks);

// Outline of connected blocks without holes, counter-clockwise, with vertices at corners only.
std::vector<Point> loop_around(const Blocks& blocks, const BlockGrid& grid);

}  // namespace bempd

#pragma once

#include <vector>

#include "pd/outlined/filling_cells.hpp"

namespace bempd::pd {

inline int corner_count(const std::array<int, 4>& cell) { return is_triangle(cell) ? 3 : 4; }

template <class Visit>
void for_each_edge(const std::array<int, 4>& cell, const Visit& visit) {
  const int count = corner_count(cell);
  for (int k = 0; k < count; ++k) visit(cell[k], cell[(k + 1) % count]);
}

// Patches: groups of cells, each with one gradient stencil (cell_stencils.hpp). Each whole lattice cell is a patch.
// Triangles form pairs across their longest edges. A triangle that is left over joins a pair beside it, if there is
// one.
struct CellPatches {
  std::vector<std::vector<int>> cells;  // cells of each patch

  // Patches that share an edge with a patch, by patch; empty for a patch without points on the outline.
  std::vector<std::vector<int>> behind_an_edge;
};

CellPatches make_patches(const std::vector<Point>& points, const FillingCells& cells, int outline_count);

}  // namespace bempd::pd

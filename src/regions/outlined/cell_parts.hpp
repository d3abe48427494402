#pragma once

#include <vector>

#include "geometry/arc.hpp"
#include "pd/outlined/filling_cells.hpp"

namespace bempd::regions {

// Cell of a body, with the share of its area that lies in one region of the body.
struct CellPart {
  int cell;
  double share;
};

// Shares out the cells of a body among its regions, given by the loops around each of them. Cells that a common edge of
// two regions crosses belong to both. Shares of a cell add up to 1. All lengths are in spacings.
std::vector<std::vector<CellPart>> parts_of_cells(const std::vector<Point>& points, const pd::FillingCells& cells,
                                                  const std::vector<std::vector<std::vector<Arc>>>& regions,
                                                  const std::vector<Arc>& common_edges);

}  // namespace bempd::regions

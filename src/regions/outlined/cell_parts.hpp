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

// Divides the cells of a body (several regions with one lattice) among its regions. `regions` has the loops around each
// region. A cell that a common edge of two regions crosses is part of both regions, with shares of its area that add up
// to 1. All lengths are in spacings.
std::vector<std::vector<CellPart>> parts_of_cells(const std::vector<Point>& points, const pd::FillingCells& cells,
                                                  const std::vector<std::vector<std::vector<Arc>>>& regions,
                                                  const std::vector<Arc>& common_edges);

}  // namespace bempd::regions

#pragma once

#include "pd/bond_draft.hpp"
#include "pd/cell_grid.hpp"

namespace bempd::pd {

// Surface vectors of the material points of a lattice with these cells.
std::vector<Point> surface_vectors(const CellLattice& lattice, const CellGrid& cells);

// Changes the stiffnesses of bonds around corners as little as possible so that no point has missing moments
// (missing_moments()). Only bonds with `in_layer` change. Returns false if no such stiffnesses were found. The result
// does not depend on the number of `threads` (0: one per core).
bool balance_corners(const CellLattice& lattice, const CellGrid& cells, int horizon_ratio, int threads,
                     DraftBonds& draft);

}  // namespace bempd::pd

#pragma once

#include "pd/bond_draft.hpp"
#include "pd/cell_grid.hpp"

namespace bempd::pd {

// Surface vectors of the material points of a lattice with these cells.
std::vector<Point> surface_vectors(const CellLattice& lattice, const CellGrid& cells);

// Changes stiffnesses around corners by the least amounts after which no point has missing moments (layer_balance.hpp).
// Bonds with `in_layer` may change. Returns false if no such stiffnesses were found. The result does not depend on
// the number of `threads` (0: one per core).
bool balance_corners(const CellLattice& lattice, const CellGrid& cells, int horizon_ratio, int threads,
                     DraftBonds& draft);

}  // namespace bempd::pd

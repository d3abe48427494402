#pragma once

#include <vector>

#include "pd/bond_draft.hpp"
#include "pd/outlined/outlined_points.hpp"

namespace bempd::pd {

// Makes the bonds between all pairs of points closer than the horizon that see each other. Between lattice points they
// have the bulk stiffness, at points of the outline that of the kernel at their length. Offsets are those of the
// lattice, turned, then one for each bond with an end on the outline.
DraftBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                const BondKernel& kernel);

// Layer of bonds at the outline whose stiffness may differ from the bulk: one end is less deep than `depth`, the other
// less deep than `deepest`. Those shorter than `reach` are free. Points deeper than the longest bond plus the gap at
// the outline have no missing moments.
struct Layer {
  double depth, deepest, reach;
};
void mark_layer(const OutlinedPoints& points, const Layer& layer, DraftBonds& bonds);

// Multiplies the stiffness k of every bond in the layer by a factor of either end, so that points resist a change of
// volume in proportion to their area. Half of the sum of k L^2 over a point's bonds of lengths L becomes 8/3 C1111
// times its area.
void share_by_area(const std::vector<double>& areas, DraftBonds& bonds);

}  // namespace bempd::pd

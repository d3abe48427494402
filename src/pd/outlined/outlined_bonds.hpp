#pragma once

#include <vector>

#include "pd/bond_draft.hpp"
#include "pd/outlined/outlined_points.hpp"

namespace bempd::pd {

// Makes the bonds between all pairs of points that are closer than the horizon and see each other. A bond between two
// lattice points has the bulk stiffness, a bond with an end on the outline the kernel's stiffness for its length. The
// list of offsets has the turned offsets of the lattice, followed by one offset for each bond with an end on the
// outline.
DraftBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                const BondKernel& kernel);

// Layer of bonds at the outline whose stiffness may differ from the bulk stiffness: bonds with one end less deep than
// `depth` and the other end less deep than `deepest`. Bonds of the layer that are shorter than `reach` are free, which
// means that balance_layer() may change them. Points deeper than the longest bond plus the gap at the outline need no
// balancing (they have no missing_moments()).
struct Layer {
  double depth, deepest, reach;
};
void mark_layer(const OutlinedPoints& points, const Layer& layer, DraftBonds& bonds);

// Multiplies the stiffness of every bond in the layer by one factor for each of its two ends, so that points resist a
// change of volume in proportion to their area. For each point, half of the sum of k L^2 over its bonds (stiffness k,
// length L) becomes about 8/3 C1111 times the point's area.
void share_by_area(const std::vector<double>& areas, DraftBonds& bonds);

}  // namespace bempd::pd

#pragma once

#include <vector>

#include "pd/outlined/chords.hpp"

namespace bempd::pd {

// Factors, close to 1, of the surface vectors of an outline's nodes, with which a network of bonds can reproduce
// constant stress exactly. (The surface vector N of a node is half the sum of the outward normals of its two chords
// times the chords' lengths.)
//
// Bonds pull along their own lines. The forces that they carry are therefore balanced under every cubic Killing tensor
// field T: the sum of T_kkl N_l over the nodes of a loop has to be zero for all ten fields. It is zero for the seven
// fields that contain the rotation at most once, because surface vectors come from hat functions on chords. For the
// other three fields the sum is zero if all pieces have chords of one length; otherwise the factors make it zero. The
// factors keep the resultant and the first moments of every loop, and the resultant and the moment of a constant load
// on every piece with enough nodes. Nodes marked `kept` have the factor 1.
//
// If `by_piece` is false, the bonds along the outline carry the imbalance of one piece to the other pieces. If it is
// true, the chords of every piece with four or more first count as if they had the common length of all chords, by
// factors of the two nodes next to each end of the piece. The bonds then carry no imbalance over long distances.
std::vector<double> balancing_factors(const Chords& chords, bool by_piece = false);

// Largest magnitude of the three sums of T_kkl N_l that have to vanish for each loop, scaled by the size of the loop.
double imbalance(const Chords& chords, const std::vector<double>& factors);

}  // namespace bempd::pd

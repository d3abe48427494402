#pragma once

#include <vector>

#include "pd/outlined/chords.hpp"

namespace bempd::pd {

// Factors, close to 1, of the surface vectors of an outline's nodes, with which a network of bonds can reproduce
// constant stress exactly. (The surface vector N of a node is half the sum of its chords' outward normals times
// lengths.)
//
// Bonds pull along their own lines, so that whatever they carry is balanced under every cubic Killing tensor field T:
// the sum of T_kkl N_l over the nodes of a loop has to be zero for all ten fields. It is zero for the seven fields that
// contain the rotation at most once, because surface vectors come from hat functions on chords. For the other three it
// is zero only if all pieces have chords of one length, else by factors. These keep the resultant and the first moments
// of every loop, and the resultant and the moment of a constant load on every piece with enough nodes. Nodes marked
// `kept` have the factor 1.
//
// Without `by_piece` the bonds along the outline carry the imbalance of one piece to the others. With it, chords of
// every piece of four or more first count as if they had one length, by factors of the two nodes next to each end of
// the piece. The bonds then carry no imbalance over long distances.
std::vector<double> balancing_factors(const Chords& chords, bool by_piece = false);

// Largest magnitude of the three numbers that have to vanish for each loop, scaled by the size of the loop.
double imbalance(const Chords& chords, const std::vector<double>& factors);

}  // namespace bempd::pd

#pragma once

#include <vector>

#include "pd/outlined/chords.hpp"

namespace bempd::pd {

// Factors of the surface vectors of the nodes with which a network can be exact.
//
// Bonds pull along their own lines, so that whatever they carry is balanced under every cubic Killing tensor field T:
// the sum of T_kkl N_l over the nodes of a loop has to be zero for all ten of them. For those that are constant or
// linear in one factor of the rotation hats on chords see to it; the remaining three numbers vanish only if all pieces
// have chords of one length. The factors are as close to 1 as that allows. They keep the resultant and the first
// moments of every loop, and the resultant and the moment of a constant load on every piece where there are enough
// nodes for it. Those of nodes that are kept are 1.
//
// What is left out of balance between pieces is carried along the outline by the bonds. `by_piece`: chords of every
// piece of four or more are first made to count as if they had one length, by factors of two nodes at either of its
// ends; then bonds carry nothing far.
std::vector<double> balancing_factors(const Chords& chords, bool by_piece = false);

// The largest of the three numbers over the length of their loop.
double imbalance(const Chords& chords, const std::vector<double>& factors);

}  // namespace bempd::pd

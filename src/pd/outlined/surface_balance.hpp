#pragma once

#include <vector>

#include "pd/outlined/chords.hpp"

namespace bempd::pd {

// Factors of the surface vectors of the nodes with which a network can be exact.
//
// Bonds pull along their own lines, so that whatever they carry is balanced under every cubic Killing tensor field T:
// the sum of T_kkl N_l over the nodes of a loop has to be zero for all ten of them. Hats on chords ensure this for
// those that are constant or linear in one factor of the rotation; the remaining three numbers vanish only if all
// pieces have chords of one length. The factors are as close to 1 as that allows. They keep the resultant and the first
// moments of every loop, and the resultant and the moment of a constant load on every piece where there are enough
// nodes for it. Nodes that are kept have the factor 1.
//
// Bonds along the outline carry the imbalance between pieces. `by_piece`: chords of every piece of four or more are
// first made to count as if they had one length, by factors of two nodes at either of its ends; then bonds carry
// nothing far.
std::vector<double> balancing_factors(const Chords& chords, bool by_piece = false);

// Largest of the three numbers over the length of their loop.
double imbalance(const Chords& chords, const std::vector<double>& factors);

}  // namespace bempd::pd

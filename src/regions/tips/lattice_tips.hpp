#pragma once

#include <vector>

#include "regions/tips/tip_search.hpp"

namespace bempd::regions {

// Results of crack tips in lattices: stress intensity factors, T-stress and error estimates, by path-independent sums
// over rings around each tip (TipRings).
std::vector<TipValues> lattice_tips(const BondedBody& body, const std::vector<LatticeTip>& tips,
                                    const Solution& solution, const scene::Options& options);

}  // namespace bempd::regions

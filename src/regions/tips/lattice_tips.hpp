#pragma once

#include <vector>

#include "regions/tips/tip_search.hpp"

namespace bempd::regions {

// What tips of cracks among bonds carry.
std::vector<TipValues> lattice_tips(const BondedBody& body, const std::vector<LatticeTip>& tips,
                                    const Solution& solution, const scene::Options& options);

}  // namespace bempd::regions

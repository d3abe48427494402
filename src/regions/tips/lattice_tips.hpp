#pragma once

#include <vector>

#include "regions/tips/tip_search.hpp"

namespace bempd::regions {

// Values of tips of cracks in lattices: stress intensity factors and what follows from them.
std::vector<TipValues> lattice_tips(const BondedBody& body, const std::vector<LatticeTip>& tips,
                                    const Solution& solution, const scene::Options& options);

}  // namespace bempd::regions

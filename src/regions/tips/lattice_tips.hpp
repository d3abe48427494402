#pragma once

#include <vector>

#include "regions/tips/tip_search.hpp"

namespace bempd::regions {

// Limit on the radius of the largest ring, in horizons; larger ones give nothing new and take longer.
constexpr double most_horizons_of_rings = 10;

// Results of crack tips in lattices by path-independent sums over rings: stress intensity factors, T-stress and error
// estimates.
std::vector<TipValues> lattice_tips(const BondedBody& body, const std::vector<LatticeTip>& tips,
                                    const Solution& solution, const scene::Options& options,
                                    double most_horizons = most_horizons_of_rings);

}  // namespace bempd::regions

#pragma once

#include <array>
#include <map>
#include <vector>

#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Swelling strains that temperature loads cause, by region id; those of several loads add up.
using SwellingOfRegions = std::map<int, std::vector<Swelling>>;

// Sets the rest lengths of bonds, cell squares and boundary elements for a swelling, before operators are asked for.
// Throws Error (argument) for a boundary element region that cannot swell in that way.
void swell(Discretization& discretization, const SwellingOfRegions& swelling);

// Swelling that changes after the operators exist: returns the new rest elongations of all terms (constant and
// proportional part), which the caller sets in `terms`. Operators have theirs in Region::nodes_of_operators().
std::array<std::vector<double>, 2> changed_rest_elongations(Discretization& discretization,
                                                            const SwellingOfRegions& swelling,
                                                            const coupling::Terms& terms);

}  // namespace bempd::regions

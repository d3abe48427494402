#pragma once

#include <array>
#include <map>
#include <vector>

#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// What loads make the material of regions want, by their ids.
using SwellingOfRegions = std::map<int, std::vector<Swelling>>;

// Gives bonds, squares of cells and boundary elements the lengths that they have without stress; before operators are
// asked for. Throws Error (argument) for a boundary element region that cannot swell like that.
void swell(Discretization& discretization, const SwellingOfRegions& swelling);

// The same for regions whose operators have been asked for: rest elongations of all terms, constant and proportional
// parts, which `terms` then have to be given; Region::rest_of_operator() tells what operators have to be.
std::array<std::vector<double>, 2> swell_again(Discretization& discretization, const SwellingOfRegions& swelling,
                                               const coupling::Terms& terms);

}  // namespace bempd::regions

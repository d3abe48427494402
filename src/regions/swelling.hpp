#pragma once

#include <array>
#include <map>
#include <vector>

#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Swelling that loads cause in the material of regions, by their ids.
using SwellingOfRegions = std::map<int, std::vector<Swelling>>;

// Gives bonds, squares of cells and boundary elements their rest lengths, before operators are asked for. Throws Error
// (argument) for a boundary element region that cannot swell like that.
void swell(Discretization& discretization, const SwellingOfRegions& swelling);

// New rest elongations of all terms, constant and proportional parts, for regions whose operators exist already; the
// caller gives them to `terms`. Region::rest_of_operator() has the rest displacements for operators.
std::array<std::vector<double>, 2> swell_again(Discretization& discretization, const SwellingOfRegions& swelling,
                                               const coupling::Terms& terms);

}  // namespace bempd::regions

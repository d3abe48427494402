#pragma once

#include <array>
#include <map>
#include <vector>

#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Swelling strains due to temperature loads, by region id. Strains of several loads on one region add up.
using SwellingOfRegions = std::map<int, std::vector<Swelling>>;

// Sets the rest elongations of bonds and cell squares (energy terms of lattice cells) and the rest displacements of
// boundary elements for swelling strains, before operators are made. Throws Error (argument) if the strain in a
// boundary element region is not linear in x and y.
void swell(Discretization& discretization, const SwellingOfRegions& swelling);

// Rest elongations of all energy terms (constant and proportional part) for swelling strains that change after the
// operators exist. The caller sets them in `terms`. RegionOperators::nodes_of_operators() has the new rest
// displacements.
std::array<std::vector<double>, 2> changed_rest_elongations(Discretization& discretization,
                                                            const SwellingOfRegions& swelling,
                                                            const coupling::Terms& terms);

}  // namespace bempd::regions

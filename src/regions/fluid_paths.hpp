#pragma once

#include "pd/fluid_paths.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Paths on which a fluid can flow when bonds break, for the bonds `terms` of the scene: a facet between two points for
// each bond that is one spacing long, and the push of a pressure on each term. Terms in `weakened` (at ends of cracks)
// have the push of whole ones.
pd::FluidPaths fluid_paths(const scene::Scene& scene, const Discretization& discretization,
                           const coupling::Terms& terms, const std::vector<pd::WeakenedTerm>& weakened);

}  // namespace bempd::regions

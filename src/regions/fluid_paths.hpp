#pragma once

#include "pd/fluid_paths.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Paths on which a fluid can flow when bonds break: a facet across each bond that is one spacing long, and for each of
// the scene's energy terms (bonds and cell squares) in `terms` the force along it due to a unit pressure. The energy
// terms in `weakened`, which lie at ends of cracks, get the force that they would have with their whole stiffness.
pd::FluidPaths fluid_paths(const scene::Scene& scene, const Discretization& discretization,
                           const coupling::Terms& terms, const std::vector<pd::WeakenedTerm>& weakened);

}  // namespace bempd::regions

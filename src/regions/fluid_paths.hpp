#pragma once

#include "pd/fluid_paths.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Paths on which a fluid can flow when bonds break: a facet across each bond that is one spacing long, and the force
// that a unit pressure exerts along each of the scene's energy terms (bonds and cell squares) in `terms`. Terms in
// `weakened`, which lie at ends of cracks, get the force of terms with their whole stiffness.
pd::FluidPaths fluid_paths(const scene::Scene& scene, const Discretization& discretization,
                           const coupling::Terms& terms, const std::vector<pd::WeakenedTerm>& weakened);

}  // namespace bempd::regions

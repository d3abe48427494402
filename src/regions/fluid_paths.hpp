#pragma once

#include "pd/fluid_paths.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Paths of a fluid through bonds of the scene, which are these terms.
pd::FluidPaths fluid_paths(const scene::Scene& scene, const Discretization& discretization,
                           const coupling::Terms& terms);

}  // namespace bempd::regions

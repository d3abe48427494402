#pragma once

#include "pd/fluid_ways.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Paths of a fluid through bonds of the scene, which are these terms.
pd::FluidWays fluid_ways(const scene::Scene& scene, const Discretization& discretization, const coupling::Terms& terms);

}  // namespace bempd::regions

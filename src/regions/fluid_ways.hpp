#pragma once

#include "pd/fluid_ways.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Through bonds of the scene, whose terms these are.
pd::FluidWays fluid_ways(const scene::Scene& scene, const Discretization& discretization, const coupling::Terms& terms);

}  // namespace bempd::regions

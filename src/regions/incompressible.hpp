#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports alone, or with each other, hold the volume of incompressible regions: then the
// pressure there has no effect on any displacement that is free.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

// Share of a solution's digits that remains in nearly incompressible regions whose whole boundary is held: 1 - 2 nu, by
// which the pressure is larger than the change of volume that it follows from; 1 if there are none. Adds a warning for
// each region that loses many digits.
double condition_of_held_pressure(const scene::Scene& scene, const Discretization& discretization,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings);

}  // namespace bempd::regions

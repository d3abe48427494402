#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports hold the volume of incompressible regions, one alone or several together, so
// that the pressure there acts on no free displacement and is undetermined.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

// Relative accuracy that remains for the pressure in nearly incompressible regions whose whole boundary is held. It is
// 1 - 2 nu, because the pressure is the change of volume divided by about this number; 1 if there is no such region.
// Adds a warning for each region that loses many digits.
double condition_of_held_pressure(const scene::Scene& scene, const Discretization& discretization,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings);

}  // namespace bempd::regions

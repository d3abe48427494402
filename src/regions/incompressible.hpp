#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports hold the volume of one incompressible region, or of several together. The
// pressure in these regions then acts on no free displacement and is undetermined.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

// Condition of the pressure in nearly incompressible regions whose whole boundary is held: the smallest 1 - 2 nu of
// these regions (in plane strain), because the pressure is the change of volume divided by about this number; 1 if
// there is no such region. Adds a warning for each region whose pressure loses many digits.
double condition_of_held_pressure(const scene::Scene& scene, const Discretization& discretization,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings);

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports hold the volume of one incompressible region, or of several together. The
// pressure in these regions then acts on no free displacement and is undetermined.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

// Smallest 1 - 2 nu of the nearly incompressible regions (in plane strain) whose whole boundary is held; 1 if there is
// no such region. The pressure in such a region is the change of volume divided by about this number, so that errors of
// displacements grow in the pressure. Adds a warning for each region whose pressure loses many digits.
double condition_of_held_pressure(const scene::Scene& scene, const Discretization& discretization,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings);

}  // namespace bempd::regions

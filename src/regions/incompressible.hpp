#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports hold the volume of incompressible regions on their own or together: then no
// displacement that they leave free changes with the pressure there.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

// What regions that are nearly incompressible, with supports that hold their whole boundary, leave of a solution's
// digits: 1 - 2 nu, by which the pressure is larger than the change of volume that it follows from; 1 if there are
// none. Adds a warning for each that loses many.
double condition_of_held_pressure(const scene::Scene& scene, const Discretization& discretization,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings);

}  // namespace bempd::regions

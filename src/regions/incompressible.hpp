#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Throws Error (unsolvable) if supports hold the volume of incompressible regions on their own or together: then no
// displacement that they leave free changes with the pressure there.
void require_determined_pressure(const Discretization& discretization, const std::vector<char>& prescribed);

}  // namespace bempd::regions

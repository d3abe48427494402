#pragma once

#include "regions/preparation.hpp"

namespace bempd::regions {

// Throws Error (argument) if regions overlap, touch at points only, or have interfaces that cannot be discretized.
void require_compatible(const Preparation& preparation);

}  // namespace bempd::regions

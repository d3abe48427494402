#pragma once

#include "regions/preparation.hpp"

namespace bempd::regions {

// Throws Error (argument) if regions overlap, touch at points only, or cannot share the interfaces that they have.
void require_compatible(const Preparation& preparation);

}  // namespace bempd::regions

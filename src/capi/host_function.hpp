#pragma once

#include "bempd.h"
#include "scene/condition.hpp"

namespace bempd::capi {

// Values on a boundary from a function of the host, which is called once for each place.
scene::BoundaryFunction host_function(bempd_boundary_function function, void* user);

}  // namespace bempd::capi

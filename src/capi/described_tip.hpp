#pragma once

#include "bempd.h"
#include "regions/tip_values.hpp"

namespace bempd::capi {

// Tip of a crack as a struct of the C interface.
bempd_crack_tip described(const regions::TipValues& tip);

}  // namespace bempd::capi

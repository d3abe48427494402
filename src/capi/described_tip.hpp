#pragma once

#include "bempd.h"
#include "model/answers.hpp"
#include "regions/tip_values.hpp"

namespace bempd::capi {

// Values of a crack tip as a struct of the C interface.
bempd_crack_tip described(const regions::TipValues& tip);

// Writes the outcome of growth to a struct that is null if the caller does not want it.
void give_growth(bempd_growth* place, const model::GrowthResult& grown);

}  // namespace bempd::capi

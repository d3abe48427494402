#pragma once

#include "elasticity/kinked_tip.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// The option growth.criterion.
KinkCriterion growth_criterion(const scene::Options& options);

}  // namespace bempd::model

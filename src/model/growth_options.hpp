#pragma once

#include "elasticity/kinked_tip.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Growth criterion that the option crack.criterion names.
KinkCriterion growth_criterion(const scene::Options& options);

}  // namespace bempd::model

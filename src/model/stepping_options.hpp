#pragma once

#include "fracture/stepping_options.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// As the host has set them; throws Error (argument) for those that exclude each other.
fracture::SteppingOptions stepping_options(const scene::Options& options);

}  // namespace bempd::model

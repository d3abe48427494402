#pragma once

#include "fracture/stepping_options.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Stepping options as the host has set them; throws Error (argument) for options that exclude each other.
fracture::SteppingOptions stepping_options(const scene::Options& options);

}  // namespace bempd::model

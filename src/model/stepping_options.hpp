#pragma once

#include "fracture/stepping_options.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Options of stepping from the options of the host; throws Error (argument) for options that exclude each other.
fracture::SteppingOptions stepping_options(const scene::Options& options);

}  // namespace bempd::model

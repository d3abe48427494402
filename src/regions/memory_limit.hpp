#pragma once

#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Throws Error (argument) for a scene with more bonds than can be numbered, and for one that needs more memory than the
// option memory.limit allows; both by estimate, before anything is built.
void require_memory(const scene::Scene& scene, const scene::Options& options);

}  // namespace bempd::regions

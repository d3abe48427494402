#pragma once

#include <string>

#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Throws Error (argument) for a scene with more bonds than can be numbered, and for one that needs more memory than the
// option memory.limit allows; both by estimate, before anything is built.
void require_memory(const scene::Scene& scene, const scene::Options& options);

// The same for what turns out while a region is meshed: throws if `bytes` are more than there are, with `what` as the
// sentence's subject and `advice` as its end.
void require_memory_for(double bytes, const std::string& what, const std::string& advice,
                        const scene::Options& options);

}  // namespace bempd::regions

#pragma once

#include <string>

#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Throws Error (argument) for a scene with more bonds than can be numbered, and for one that needs more memory than the
// option memory.limit allows; both by estimate, before anything is built.
void require_memory(const scene::Scene& scene, const scene::Options& options);

// Throws Error (argument) if `bytes` are more than the memory allowed, for needs that appear only while a region is
// meshed; `what` is the sentence's subject and `advice` its end.
void require_memory_for(double bytes, const std::string& what, const std::string& advice,
                        const scene::Options& options);

}  // namespace bempd::regions

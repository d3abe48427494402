#pragma once

#include <string>

#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Throws Error (argument), before anything is built, for a scene with more bonds than can be numbered, or with an
// estimated need of memory beyond the option memory.limit.
void require_memory(const scene::Scene& scene, const scene::Options& options);

// Memory [B] that preparing may take: the option memory.limit, or all that the process may use if the option is 0.
double memory_allowed(const scene::Options& options);

// Throws Error (argument) if `bytes` exceed the memory limit. The function is for needs that are known only while a
// region is meshed. `what` is the subject of the error's sentence, `advice` its end.
void require_memory_for(double bytes, const std::string& what, const std::string& advice,
                        const scene::Options& options);

}  // namespace bempd::regions

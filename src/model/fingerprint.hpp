#pragma once

#include <cstdint>

#include "regions/boundary_conditions.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Fingerprint of what the host has described: equal descriptions have equal fingerprints. Computed values are left out,
// because their last digits depend on the processor.
struct SceneFingerprint {
  std::uint64_t body = 0;               // regions with their materials, initial cracks, options that shape the system
  std::uint64_t supports = 0;           // places and components of supports in their order, without values
  std::uint64_t loads = 0;              // places and components of loads; a run may continue under other loads
  std::uint64_t body_of_format_14 = 0;  // `body` as in states of format 14; not stored in other formats
};

SceneFingerprint fingerprint(const scene::Scene& scene, const scene::Options& options);

// Hash of the loads with their values, and of the values of supports. If the host gave functions, the values at the
// degrees of freedom (`values`) are hashed as well.
std::uint64_t load_fingerprint(const scene::Scene& scene, const regions::DofConditions& values);

}  // namespace bempd::model

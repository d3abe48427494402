#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "regions/discretization.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Tip of a crack around which clear_radius() measures.
struct ClearTip {
  crack::TipId id;
  Point place{0, 0}, direction{1, 0};
};

// Radius around a tip within which there is only the straight crack behind the tip: no edge, no other material, no
// other crack, and no bend or other end of the tip's own crack. `paths` are the paths of all cracks in the order of
// their ids, empty for a crack that does not exist.
double clear_radius(const scene::Scene& scene, const regions::Discretization& discretization,
                    const std::vector<std::vector<Point>>& paths, const ClearTip& tip);

}  // namespace bempd::model

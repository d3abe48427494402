#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "regions/discretization.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Crack end around which the clear radius is asked.
struct ClearTip {
  crack::TipId id;
  Point place{0, 0}, direction{1, 0};
};

// Radius around a tip that contains nothing but the tip and the straight crack behind it: no edge, no other material,
// no other crack, and no bend or end of its own. `paths` are those of all cracks, empty for one that there is not.
double clear_radius(const scene::Scene& scene, const regions::Discretization& discretization,
                    const std::vector<std::vector<Point>>& paths, const ClearTip& tip);

}  // namespace bempd::model

#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// End of an extension, and the state of the tip there.
struct ExtensionEnd {
  Point to;
  crack::TipState state;
};

// End of a straight extension of the tip at `end` of a crack, by a given length. The extension ends at the first edge,
// hole or crack that it meets. If an edge, hole or crack lies only a little farther ahead, the extension reaches to it,
// because the thin ligament would break. An extension that closely passes the end of a crack ends there. The extension
// stops before an interface, unless the region behind has the same material. It crosses an interface between boundary
// element regions of one material as if there were no interface; behind an interface with a lattice it ends between
// material points.
ExtensionEnd end_of_extension(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                              const Point& direction, double length, double tolerance);

// Appends a point at an end of a crack: 1 is the last point, 0 the first.
void extend(scene::Crack& crack, int end, const Point& to);

double length_of(const scene::Crack& crack);

// Distance from a tip to the nearest edge, hole or other crack [m]. Interfaces between boundary element regions of one
// material, which cracks can cross, do not count.
double clearance_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end);

}  // namespace bempd::model

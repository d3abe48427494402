#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// End of a tip's path, and the tip's state there.
struct ExtensionEnd {
  Point to;
  crack::TipState state;  // there
};

// Straight path of the tip at `end` of a crack for an extension of the given length. It ends at the first edge, hole or
// crack that lies on it or a little beyond, because a thin ligament breaks; and at the end of a crack that it passes
// closely.
// It stops before an interface, except with a region of the same material: it crosses an interface with boundary
// elements as if there were none, and continues in a lattice to a place between material points.
ExtensionEnd end_of_extension(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                              const Point& direction, double length, double tolerance);

// Appends a point at an end of a crack: 1 is the last point, 0 the first.
void extend(scene::Crack& crack, int end, const Point& to);

double length_of(const scene::Crack& crack);

// Distance from a tip to the nearest edge, hole or other crack [m]. Interfaces that the crack can cross into other
// boundary elements do not count.
double clearance_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end);

}  // namespace bempd::model

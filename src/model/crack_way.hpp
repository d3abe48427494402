#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Place that a tip reaches, and its state there.
struct TipWay {
  Point to;
  crack::TipState state;  // there
};

// Path of the tip at `end` of a crack that grows straight on by a length. It ends at the first edge, hole or crack that
// lies on it or a little beyond, because a thin ligament breaks; it ends at a crack's own end if it passes close to
// that. It stops before an edge that another region shares, unless that region is of the same material: then it goes on
// in boundary elements as if there were no edge, and to the points behind the edge of a lattice.
TipWay way_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                  const Point& direction, double length, double tolerance);

// Appends a point at an end of a crack, 1 for its last one.
void extend(scene::Crack& crack, int end, const Point& to);

double length_of(const scene::Crack& crack);

// Distance from a tip to the nearest edge, hole or other crack, without edges on which it goes on in the boundary
// elements of another region [m].
double clearance_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end);

}  // namespace bempd::model

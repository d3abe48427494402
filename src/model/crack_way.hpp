#pragma once

#include <vector>

#include "crack/tip.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Where a tip comes to.
struct TipWay {
  Point to;
  crack::TipState state;  // there
};

// The way of the tip at `end` of a crack that goes straight on by a length: to the first edge, hole or crack that lies
// on it or little beyond, for a thin ligament breaks; to a crack's own end if it passes close to that. Before an edge
// that another region shares it stops, unless that is a lattice of the same material: it goes on to the points behind
// it.
TipWay way_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                  const Point& direction, double length, double tolerance);

// Puts a point behind an end of a crack, 1 for its last one.
void extend(scene::Crack& crack, int end, const Point& to);

double length_of(const scene::Crack& crack);

// Distance from a tip to the nearest edge, hole or other crack [m].
double clearance_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end);

}  // namespace bempd::model

#pragma once

#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Curve with a continuous tangent through at least three points: one biarc, or one arc, from each point to the next.
// Tangents are those of the circle through a point and its neighbours; at the ends of an open curve, of the circle
// through the last three points. Points on a circle give that circle; smooth curves are met to third order.
std::vector<Edge> smooth_curve(const std::vector<Point>& points, bool closed);

}  // namespace bempd

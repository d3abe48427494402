#pragma once

#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Curve with a continuous tangent through at least three points: an arc or a biarc from each point to the next. The
// tangent at a point is that of the circle through it and its neighbours; at an end of an open curve, that of the
// circle through the last three points. Points on a circle give that circle; smooth curves are approximated to third
// order.
std::vector<Edge> smooth_curve(const std::vector<Point>& points, bool closed);

}  // namespace bempd

#pragma once

#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Curve with a continuous tangent through at least three points: an arc or a biarc from each point to the next. The
// tangent at a point is that of the circle through the point and its two neighbours. At an end of an open curve it is
// that of the circle through the last three points. Points on a circle give this circle; smooth curves are approximated
// to third order.
std::vector<Edge> smooth_curve(const std::vector<Point>& points, bool closed);

}  // namespace bempd

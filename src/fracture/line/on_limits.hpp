#pragma once

#include <algorithm>

#include "geometry/turning.hpp"

namespace bempd::fracture {

// What lies as near as this to a limit, in lengths of what is compared, lies on it whatever rounding says: tips of
// symmetric bodies pass through points, and the same way is rounded otherwise in a window and in the whole body.
constexpr double rounding_of_places = 1e-8;

// Whether c lies to the left of the way from a to b; what lies on it does not.
inline bool is_left(const Point& a, const Point& b, const Point& c) {
  const Point way = b - a, to = c - a;
  return cross(way, to) > rounding_of_places * way.norm() * std::max(way.norm(), to.norm());
}

}  // namespace bempd::fracture

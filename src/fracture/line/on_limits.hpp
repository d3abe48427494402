#pragma once

#include <algorithm>

#include "geometry/point.hpp"

namespace bempd::fracture {

// Relative distance from a limit below which a place counts as on the limit, so that rounding does not decide. For
// example, tips of symmetric bodies pass exactly through points, and a window (region around crack tips that is solved
// alone) rounds the same path differently from the whole body.
constexpr double rounding_of_places = 1e-8;

// Whether c lies to the left of the line from a to b; false for a point on the line.
inline bool is_left(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a;
  return cross(ab, ac) > rounding_of_places * ab.norm() * std::max(ab.norm(), ac.norm());
}

}  // namespace bempd::fracture

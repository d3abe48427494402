#pragma once

#include <cmath>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd::test {

inline std::vector<Point> box_loop(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline std::vector<Point> reversed(std::vector<Point> loop) { return {loop.rbegin(), loop.rend()}; }

inline Outline box(double x0, double y0, double x1, double y1) { return {{box_loop(x0, y0, x1, y1)}}; }

// Turned by `angle`, then scaled, then moved.
struct Placement {
  double scale = 1;
  double angle = 0;
  Point shift = Point::Zero();

  Point operator()(const Point& p) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return shift + scale * Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  }
  Outline operator()(Outline outline) const {
    for (auto& loop : outline.loops)
      for (Point& p : loop) p = (*this)(p);
    return outline;
  }
  std::vector<Outline> operator()(std::vector<Outline> outlines) const {
    for (Outline& outline : outlines) outline = (*this)(outline);
    return outlines;
  }
};

// Sizes from nanometres to millions of kilometres, near to and far from the origin.
inline std::vector<Placement> placements() {
  return {{},
          {1, 0.3, {0, 0}},
          {1e-9, 0, {0, 0}},
          {1e-9, 1.1, {1e-4, -3e-4}},
          {1e9, 0, {1e9, 1e9}},
          {1e9, 2.7, {-1e12, 1e13}},
          {0.1, 0, {1e5 / 3, -2e5 / 7}},
          {1, -0.7, {1e6 / 3, 1e6}},
          {1, 0.3, {1e9, 1e9}}};
}

}  // namespace bempd::test

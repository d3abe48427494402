#pragma once

#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// Directed straight piece between two points.
struct Segment {
  Point start, end;

  Point direction() const { return end - start; }
  double length() const { return direction().norm(); }
  Point at(double fraction) const;  // exactly `start` at 0 and `end` at 1
};

// Fraction of the length, in [0, 1], at which the segment is closest to `p`.
double closest_fraction(const Segment& segment, const Point& p);

double distance(const Segment& segment, const Point& p);

// Length of a polyline, and distance of a place from it; infinite if it has no piece.
double polyline_length(const std::vector<Point>& points);
double polyline_distance(const std::vector<Point>& points, const Point& place);

struct Crossing {
  double fraction_a, fraction_b;
};

// Crossing of two segments, each of which has its ends strictly on opposite sides of the other; decided without
// tolerance. Empty if they do not cross.
std::optional<Crossing> proper_crossing(const Segment& a, const Segment& b);

struct Approach {
  double distance;
  Point where;  // half way between the closest places of the two segments
};

Approach closest_approach(const Segment& a, const Segment& b);

}  // namespace bempd

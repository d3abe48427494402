#pragma once

#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// Directed straight piece.
struct Segment {
  Point start, end;

  Point direction() const { return end - start; }
  double length() const { return direction().norm(); }
  Point at(double fraction) const;  // exactly `start` at 0 and `end` at 1
};

// Fraction in [0, 1] of the place on the segment that is closest to `p`.
double closest_fraction(const Segment& segment, const Point& p);

double distance(const Segment& segment, const Point& p);

double polyline_length(const std::vector<Point>& points);

struct Crossing {
  double fraction_a, fraction_b;
};

// Crossing of two segments whose ends lie strictly on opposite sides of each other; decided without tolerance.
std::optional<Crossing> proper_crossing(const Segment& a, const Segment& b);

struct Approach {
  double distance;
  Point where;  // half way between the closest places of the two
};

Approach closest_approach(const Segment& a, const Segment& b);

}  // namespace bempd

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/segment.hpp"

namespace bempd {

// Circular arc from `start` to `end`. Along it the tangent turns by `sweep`: positive counter-clockwise, less than a
// full turn, 0 for a straight piece. Formulas use the chord, so that nearly straight arcs lose no digits.
struct Arc {
  Point start, end;
  double sweep = 0;  // [rad]

  bool straight() const { return sweep == 0; }
  Segment chord() const { return {start, end}; }
  double length() const;
  Point at(double fraction) const;       // fraction of the length; exactly `start` at 0 and `end` at 1
  Point tangent(double fraction) const;  // unit vector
  Arc part(double from, double to) const;
  double sagitta() const;  // largest distance from the chord, with the sign of the sweep
  Point centre() const;    // for curved arcs only
};

// Arc from `start` to `end` through the place `between`. Empty if there is no such arc, because `between` is one of the
// ends, or lies on the line through both ends but not between them.
std::optional<Arc> arc_through(const Point& start, const Point& between, const Point& end);

// Lower bound on the distance of `p` from the arc, computed without trigonometric functions unless the arc is larger
// than half a circle.
double least_distance(const Arc& arc, const Point& p);

// Fraction of the length, in [0, 1], at which the arc is closest to `p`.
double closest_fraction(const Arc& arc, const Point& p);

// Whether `p` lies between the arc and its chord. Points on the chord count as lying on its right.
bool in_circular_segment(const Arc& arc, const Point& p);

// Crossings of two pieces, at least one of them curved, with places where the pieces touch and common ends.
std::vector<Crossing> meeting_points(const Arc& a, const Arc& b);

// Place where two pieces come as close as `tolerance` to each other; empty if there is none.
std::optional<Point> find_contact(const Arc& a, const Arc& b, double tolerance);

// Biarc from `start` to `end` with the given unit tangents at both ends: two arcs with a common tangent at their joint
// (Bolton, Computer-Aided Design 7, 1975). Among all possible joints, the one with equal tangent lengths is chosen.
std::array<Arc, 2> biarc(const Point& start, const Point& start_tangent, const Point& end, const Point& end_tangent);

}  // namespace bempd

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/segment.hpp"

namespace bempd {

// Circular arc from start to end along which the tangent turns by `sweep`: counter-clockwise positive, less than a full
// turn, 0 for a straight piece. It is written with the chord, so that nearly straight arcs lose no digits.
struct Arc {
  Point start, end;
  double sweep = 0;  // [rad]

  bool straight() const { return sweep == 0; }
  Segment chord() const { return {start, end}; }
  double length() const;
  Point at(double fraction) const;       // by length; exactly `start` at 0 and `end` at 1
  Point tangent(double fraction) const;  // unit vector
  Arc part(double from, double to) const;
  double sagitta() const;  // largest distance from the chord, with the sign of the sweep
  Point centre() const;    // only of a curved arc
};

// Arc through a place between its ends; empty if there is none (the place is an end, or on their line outside of them).
std::optional<Arc> arc_through(const Point& start, const Point& between, const Point& end);

// Fraction in [0, 1] of the place on the arc that is closest to `p`.
double closest_fraction(const Arc& arc, const Point& p);

// Whether `p` lies between the arc and its chord. A point of the chord counts as lying on its right.
bool in_circular_segment(const Arc& arc, const Point& p);

// Crossings of two pieces at least one of which is curved, tangential contacts and common ends included.
std::vector<Crossing> meeting_points(const Arc& a, const Arc& b);

// Place where the two pieces come as close as `tolerance`; empty if there is none.
std::optional<Point> find_contact(const Arc& a, const Arc& b, double tolerance);

// Biarc: two arcs with a common tangent at their joint, from `start` to `end`, with the unit tangents given there
// (Bolton, Computer-Aided Design 7, 1975; the joint is the one with equal tangent lengths).
std::array<Arc, 2> biarc(const Point& start, const Point& start_tangent, const Point& end, const Point& end_tangent);

}  // namespace bempd

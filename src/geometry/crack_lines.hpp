#pragma once

#include <array>
#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Polyline of a crack; `id` is used in messages. `grown_at_start` and `grown_at_end` are the numbers of segments that
// growth has added at its ends.
struct CrackPath {
  int id;
  std::vector<Point> points;
  int grown_at_start = 0, grown_at_end = 0;
  double given_elsewhere = 0;  // length before growth if parts of the crack lie in other bodies [m]

  int segments() const { return static_cast<int>(points.size()) - 1; }
  bool grown(int segment) const { return segment < grown_at_start || segment >= segments() - grown_at_end; }
};

// Crack line: piece of a crack between two places where the crack ends, meets another crack or reaches the boundary,
// without such a place in between.
struct CrackLine {
  int crack;  // number of its crack path
  std::vector<Point> points;
  double start;                // distance along the crack path at which the line starts
  std::array<int, 2> joints;   // joints at its start and end; -1: a tip
  std::vector<char> grown;     // flag of each segment
  double given_elsewhere = 0;  // CrackPath::given_elsewhere

  double length() const;
};

// Joint: a place where crack lines meet each other or, at a mouth, the boundary.
struct CrackJoint {
  Point place;
  bool mouth;
};

struct CrackLines {
  std::vector<CrackLine> lines;
  std::vector<CrackJoint> joints;
};

// Divides the cracks inside a body into crack lines at the places where cracks meet; `boundary` has all edges of the
// body. Throws Error (argument) for cracks that leave the body, run along its boundary or along each other, or fold
// back on themselves.
CrackLines crack_lines(const std::vector<CrackPath>& paths, const std::vector<Edge>& boundary, double tolerance);

}  // namespace bempd

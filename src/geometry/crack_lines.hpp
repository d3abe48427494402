#pragma once

#include <array>
#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Polyline of a crack; `id` is for messages. grown_at_start and grown_at_end count the segments that growth has added
// at its ends.
struct CrackPath {
  int id;
  std::vector<Point> points;
  int grown_at_start = 0, grown_at_end = 0;
  double given_elsewhere = 0;  // length of what the crack was before it grew, if parts of it lie in other bodies [m]

  int segments() const { return static_cast<int>(points.size()) - 1; }
  bool grown(int segment) const { return segment < grown_at_start || segment >= segments() - grown_at_end; }
};

// Piece of a crack between the places where it ends, meets another crack or reaches the boundary.
struct CrackLine {
  int crack;  // position of the path
  std::vector<Point> points;
  double start;                // its way along the path
  std::array<int, 2> joints;   // at its start and end; -1: a tip
  std::vector<char> grown;     // by segment
  double given_elsewhere = 0;  // CrackPath::given_elsewhere

  double length() const;
};

// Place where lines meet each other or, at a mouth, the boundary.
struct CrackJoint {
  Point place;
  bool mouth;
};

struct CrackLines {
  std::vector<CrackLine> lines;
  std::vector<CrackJoint> joints;
};

// Parts the cracks inside a body where they meet; `boundary` holds all its edges. Throws Error (argument) for cracks
// that leave the body, run along its boundary or along each other, or fold back onto themselves.
CrackLines crack_lines(const std::vector<CrackPath>& paths, const std::vector<Edge>& boundary, double tolerance);

}  // namespace bempd

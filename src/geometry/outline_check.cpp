#include "geometry/outline_check.hpp"

#include <algorithm>
#include <cmath>

namespace bempd {

namespace {

// Squares and fourth powers of coordinates must stay within the range of a double.
constexpr double largest_coordinate = 1e75;

struct Loop {
  int number;
  int first_edge;
  const std::vector<Point>& vertices;

  int size() const { return static_cast<int>(vertices.size()); }
  Segment edge(int k) const { return {vertices[k], vertices[(k + 1) % vertices.size()]}; }
};

OutlineCheck defect_in(const Loop& loop, OutlineDefect defect, int edge_a, int edge_b, const Point& where) {
  return {defect, loop.number, loop.first_edge + edge_a, edge_b < 0 ? -1 : loop.first_edge + edge_b, where};
}

bool far_apart(const Segment& a, const Segment& b, double tolerance) {
  for (int i = 0; i < 2; ++i) {
    if (std::max(a.start[i], a.end[i]) + tolerance < std::min(b.start[i], b.end[i])) return true;
    if (std::max(b.start[i], b.end[i]) + tolerance < std::min(a.start[i], a.end[i])) return true;
  }
  return false;
}

OutlineCheck check_vertices(const Loop& loop) {
  for (int k = 0; k < loop.size(); ++k) {
    const Point& p = loop.vertices[k];
    // Written so that NaN fails.
    if (!(std::abs(p.x()) <= largest_coordinate && std::abs(p.y()) <= largest_coordinate))
      return defect_in(loop, OutlineDefect::not_finite, k, -1, p);
  }
  if (loop.size() < 3) return {OutlineDefect::too_few_vertices, loop.number, -1, -1, Point::Zero()};
  return {};
}

OutlineCheck check_lengths(const Loop& loop, double tolerance) {
  for (int k = 0; k < loop.size(); ++k)
    if (!(loop.edge(k).length() > tolerance))
      return defect_in(loop, OutlineDefect::repeated_vertex, k, -1, loop.vertices[k]);
  return {};
}

// Consecutive edges always meet in one vertex; they may not meet again.
OutlineCheck check_spike(const Loop& loop, int k, double tolerance) {
  const int next = (k + 1) % loop.size();
  const Segment a = loop.edge(k), b = loop.edge(next);
  if (distance(a, b.end) <= tolerance || distance(b, a.start) <= tolerance)
    return defect_in(loop, OutlineDefect::spike, k, next, b.start);
  return {};
}

OutlineCheck check_self_crossing(const Loop& loop, double tolerance) {
  for (int k = 0; k < loop.size(); ++k)
    if (const OutlineCheck check = check_spike(loop, k, tolerance); !check.sound()) return check;
  for (int a = 0; a < loop.size(); ++a) {
    for (int b = a + 2; b < loop.size(); ++b) {
      if (a == 0 && b == loop.size() - 1) continue;
      if (far_apart(loop.edge(a), loop.edge(b), tolerance)) continue;
      const Approach approach = closest_approach(loop.edge(a), loop.edge(b));
      if (approach.distance <= tolerance) return defect_in(loop, OutlineDefect::self_crossing, a, b, approach.where);
    }
  }
  return {};
}

OutlineCheck check_orientation(const Loop& loop) {
  if ((signed_area(loop.vertices) > 0) == (loop.number == 0)) return {};
  return {OutlineDefect::wrong_orientation, loop.number, -1, -1, loop.vertices[0]};
}

OutlineCheck check_contact(const Loop& a, const Loop& b, OutlineDefect defect, double tolerance) {
  for (int i = 0; i < a.size(); ++i) {
    for (int j = 0; j < b.size(); ++j) {
      if (far_apart(a.edge(i), b.edge(j), tolerance)) continue;
      const Approach approach = closest_approach(a.edge(i), b.edge(j));
      if (approach.distance <= tolerance) return {defect, b.number, a.first_edge + i, b.first_edge + j, approach.where};
    }
  }
  return {};
}

// Only for loops that do not meet: then one vertex decides for all.
bool lies_within(const Loop& inner, const Loop& outer) {
  return locate(Outline{{outer.vertices}}, inner.vertices[0], 0) == Location::inside;
}

OutlineCheck check_hole(const std::vector<Loop>& loops, std::size_t hole, double tolerance) {
  const Loop& b = loops[hole];
  if (const OutlineCheck check = check_contact(loops[0], b, OutlineDefect::hole_outside, tolerance); !check.sound())
    return check;
  if (!lies_within(b, loops[0])) return {OutlineDefect::hole_outside, b.number, -1, -1, b.vertices[0]};
  for (std::size_t other = 1; other < hole; ++other) {
    const Loop& a = loops[other];
    if (const OutlineCheck check = check_contact(a, b, OutlineDefect::holes_overlap, tolerance); !check.sound())
      return check;
    if (lies_within(b, a)) return {OutlineDefect::holes_overlap, b.number, -1, -1, b.vertices[0]};
    if (lies_within(a, b)) return {OutlineDefect::holes_overlap, b.number, -1, -1, a.vertices[0]};
  }
  return {};
}

std::vector<Loop> number_loops(const Outline& outline) {
  std::vector<Loop> loops;
  int first_edge = 0;
  for (const auto& vertices : outline.loops) {
    loops.push_back({static_cast<int>(loops.size()), first_edge, vertices});
    first_edge += static_cast<int>(vertices.size());
  }
  return loops;
}

}  // namespace

OutlineCheck check_outline(const Outline& outline) {
  const std::vector<Loop> loops = number_loops(outline);
  if (loops.empty()) return {OutlineDefect::too_few_vertices, 0, -1, -1, Point::Zero()};
  for (const Loop& loop : loops)
    if (const OutlineCheck check = check_vertices(loop); !check.sound()) return check;
  const double tolerance = geometric_tolerance(bounding_box(outline));
  for (const Loop& loop : loops) {
    if (const OutlineCheck check = check_lengths(loop, tolerance); !check.sound()) return check;
    if (const OutlineCheck check = check_self_crossing(loop, tolerance); !check.sound()) return check;
    if (const OutlineCheck check = check_orientation(loop); !check.sound()) return check;
  }
  for (std::size_t hole = 1; hole < loops.size(); ++hole)
    if (const OutlineCheck check = check_hole(loops, hole, tolerance); !check.sound()) return check;
  return {};
}

}  // namespace bempd

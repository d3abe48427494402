#include "geometry/outline_check.hpp"

#include <cmath>

#include "geometry/edge_tree.hpp"

namespace bempd {

namespace {

// Largest coordinate accepted: its square and fourth power must stay within the range of a double.
constexpr double largest_coordinate = 1e75;

struct Loop {
  int number;
  int first_edge;
  const std::vector<Point>& vertices;
  EdgeTree boundary{{}};

  int size() const { return static_cast<int>(vertices.size()); }
  const Edge& edge(int k) const { return boundary.edges[static_cast<std::size_t>(k)]; }
};

OutlineCheck defect_in(const Loop& loop, OutlineDefect defect, int edge_a, int edge_b, const Point& where) {
  return {defect, loop.number, loop.first_edge + edge_a, edge_b < 0 ? -1 : loop.first_edge + edge_b, where};
}

Box widened(const Box& box, double tolerance) {
  const Point margin = Point::Constant(tolerance);
  return {box.min() - margin, box.max() + margin};
}

OutlineCheck check_vertices(const Loop& loop) {
  for (int k = 0; k < loop.size(); ++k) {
    const Point& p = loop.vertices[k];
    // The comparison is written so that NaN fails.
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

// Checks edge `k` and the next one, which meet in one vertex: they must not turn back nor meet again.
OutlineCheck check_spike(const Loop& loop, int k, double tolerance) {
  const int next = (k + 1) % loop.size();
  const Edge &a = loop.edge(k), &b = loop.edge(next);
  if (distance(a, b.end) <= tolerance || distance(b, a.start) <= tolerance)
    return defect_in(loop, OutlineDefect::spike, k, next, b.start);
  if (a.straight() && b.straight()) return {};
  constexpr double smallest_angle = 1e-6;
  const Point along = a.tangent(1), on = b.tangent(0);
  if (along.dot(on) < 0 && std::abs(cross(along, on)) < smallest_angle)
    return defect_in(loop, OutlineDefect::spike, k, next, b.start);
  for (const Crossing& crossing : meeting_points(a, b)) {
    const Point where = a.at(crossing.fraction_a);
    if ((where - b.start).norm() > 10 * tolerance) return defect_in(loop, OutlineDefect::self_crossing, k, next, where);
  }
  return {};
}

OutlineCheck check_self_crossing(const Loop& loop, double tolerance) {
  for (int k = 0; k < loop.size(); ++k)
    if (const OutlineCheck check = check_spike(loop, k, tolerance); !check.sound()) return check;
  for (int a = 0; a < loop.size(); ++a) {
    for (const int b : loop.boundary.tree.meeting(widened(bounding_box(loop.edge(a)), tolerance))) {
      if (b < a + 2 || (a == 0 && b == loop.size() - 1)) continue;
      if (const auto where = find_contact(loop.edge(a), loop.edge(b), tolerance))
        return defect_in(loop, OutlineDefect::self_crossing, a, b, *where);
    }
  }
  return {};
}

OutlineCheck check_orientation(const Loop& loop) {
  if ((signed_area(loop.boundary.edges) > 0) == (loop.number == 0)) return {};
  return {OutlineDefect::wrong_orientation, loop.number, -1, -1, loop.vertices[0]};
}

OutlineCheck check_contact(const Loop& a, const Loop& b, OutlineDefect defect, double tolerance) {
  for (const int i : a.boundary.tree.meeting(widened(b.boundary.box, tolerance))) {
    for (const int j : b.boundary.tree.meeting(widened(bounding_box(a.edge(i)), tolerance))) {
      if (const auto where = find_contact(a.edge(i), b.edge(j), tolerance))
        return {defect, b.number, a.first_edge + i, b.first_edge + j, *where};
    }
  }
  return {};
}

// Whether loop `inner` lies within loop `outer`. The two must not meet, so that one vertex decides for all.
bool lies_within(const Loop& inner, const Loop& outer) {
  return outer.boundary.locate(inner.vertices[0], 0) == Location::inside;
}

OutlineCheck check_hole(const std::vector<Loop>& loops, const BoxTree& tree, int hole, double tolerance) {
  const Loop& b = loops[hole];
  if (const OutlineCheck check = check_contact(loops[0], b, OutlineDefect::hole_outside, tolerance); !check.sound())
    return check;
  if (!lies_within(b, loops[0])) return {OutlineDefect::hole_outside, b.number, -1, -1, b.vertices[0]};
  for (const int other : tree.meeting(widened(b.boundary.box, tolerance))) {
    if (other == 0) continue;
    if (other == hole) break;
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

void add_edges(const Outline& outline, std::vector<Loop>& loops) {
  const std::vector<Edge> edges = edges_of(outline);
  for (Loop& loop : loops) {
    const auto first = edges.begin() + loop.first_edge;
    loop.boundary = EdgeTree({first, first + loop.size()});
  }
}

}  // namespace

OutlineCheck check_outline(const Outline& outline) {
  std::vector<Loop> loops = number_loops(outline);
  if (loops.empty()) return {OutlineDefect::too_few_vertices, 0, -1, -1, Point::Zero()};
  for (const Loop& loop : loops)
    if (const OutlineCheck check = check_vertices(loop); !check.sound()) return check;
  add_edges(outline, loops);
  const double tolerance = geometric_tolerance(bounding_box(outline));
  for (const Loop& loop : loops) {
    if (const OutlineCheck check = check_lengths(loop, tolerance); !check.sound()) return check;
    if (const OutlineCheck check = check_self_crossing(loop, tolerance); !check.sound()) return check;
    if (const OutlineCheck check = check_orientation(loop); !check.sound()) return check;
  }
  std::vector<Box> boxes;
  boxes.reserve(loops.size());
  for (const Loop& loop : loops) boxes.push_back(loop.boundary.box);
  const BoxTree tree(boxes);
  for (int hole = 1; hole < static_cast<int>(loops.size()); ++hole)
    if (const OutlineCheck check = check_hole(loops, tree, hole, tolerance); !check.sound()) return check;
  return {};
}

}  // namespace bempd

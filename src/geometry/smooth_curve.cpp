#include "geometry/smooth_curve.hpp"

#include <cassert>
#include <cmath>

namespace bempd {

namespace {

// Tangent at the middle one of three points: the sum of the directions of both chords, each weighted with the length of
// the other chord.
Point middle_tangent(const Point& before, const Point& at, const Point& after) {
  const Point u = at - before, v = after - at;
  const Point sum = u * v.squaredNorm() + v * u.squaredNorm();
  // Three points, the last of which runs straight back to the first, have no tangent. Any direction is good then,
  // because the outline check rejects the spike.
  return sum.norm() > 0 ? Point(sum.normalized()) : Point(u.normalized());
}

// Tangent at the first of three points on a circle: the tangent at the second point, mirrored in the chord between the
// two.
Point first_tangent(const Point& first, const Point& next, const Point& tangent_at_next) {
  const Point chord = (next - first).normalized();
  return 2 * chord.dot(tangent_at_next) * chord - tangent_at_next;
}

// Edge with given tangents at both ends: one arc if the tangents mirror each other in the chord, else a biarc.
Edge edge_between(const Point& start, const Point& start_tangent, const Point& end, const Point& end_tangent) {
  const Point mirrored = first_tangent(start, end, end_tangent);
  constexpr double same = 1e-9;
  if ((mirrored - start_tangent).norm() > same) return Edge(biarc(start, start_tangent, end, end_tangent));
  const double turn = std::atan2(cross(start_tangent, end_tangent), start_tangent.dot(end_tangent));
  return Edge(Arc{start, end, std::abs(turn) < same ? 0.0 : turn});
}

}  // namespace

std::vector<Edge> smooth_curve(const std::vector<Point>& points, bool closed) {
  const std::size_t n = points.size(), edge_count = closed ? n : n - 1;
  assert(n >= 3);
  std::vector<Point> tangents(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && (i == 0 || i + 1 == n)) continue;
    tangents[i] = middle_tangent(points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
  }
  if (!closed) {
    tangents[0] = first_tangent(points[0], points[1], tangents[1]);
    tangents[n - 1] = first_tangent(points[n - 2], points[n - 1], tangents[n - 2]);
  }
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < edge_count; ++i) {
    const std::size_t next = (i + 1) % n;
    edges.push_back(edge_between(points[i], tangents[i], points[next], tangents[next]));
  }
  return edges;
}

}  // namespace bempd

#include "geometry/outline.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace bempd {

std::vector<Segment> edges_of(const Outline& outline) {
  std::vector<Segment> edges;
  for (const auto& loop : outline.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) edges.push_back({loop[k], loop[(k + 1) % loop.size()]});
  return edges;
}

Box bounding_box(const Outline& outline) {
  Box box;
  for (const auto& loop : outline.loops)
    for (const Point& vertex : loop) box.extend(vertex);
  return box;
}

double geometric_tolerance(const Box& box) {
  if (box.isEmpty()) return 0;
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max(1e-9 * box.diagonal().norm(), 4 * std::numeric_limits<double>::epsilon() * largest);
}

double signed_area(const std::vector<Point>& loop) {
  // Measured from the first vertex: no cancellation far from the origin.
  double twice = 0;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) twice += cross(loop[k] - loop[0], loop[k + 1] - loop[0]);
  return 0.5 * twice;
}

double area(const Outline& outline) {
  double sum = 0;
  for (const auto& loop : outline.loops) sum += signed_area(loop);
  return sum;
}

Location locate(const std::vector<Segment>& boundary, const Point& p, double tolerance) {
  bool inside = false;
  for (const Segment& edge : boundary) {
    if (distance(edge, p) <= tolerance) return Location::on_boundary;
    // Even-odd rule along the ray to the right; an edge owns its lower end only, so a vertex counts once.
    const bool upward = edge.end.y() > p.y();
    if ((edge.start.y() > p.y()) == upward) continue;
    if ((cross(edge.direction(), p - edge.start) > 0) == upward) inside = !inside;
  }
  return inside ? Location::inside : Location::outside;
}

Location locate(const Outline& outline, const Point& p, double tolerance) {
  return locate(edges_of(outline), p, tolerance);
}

Point some_interior_point(const Outline& outline) {
  const std::vector<Segment> edges = edges_of(outline);
  assert(!edges.empty());
  const auto longest = std::max_element(edges.begin(), edges.end(), [](const Segment& a, const Segment& b) {
    return a.direction().squaredNorm() < b.direction().squaredNorm();
  });
  const Point direction = longest->direction().normalized();
  const Point inward(-direction.y(), direction.x());
  const Point middle = longest->at(0.5);
  double width = std::numeric_limits<double>::infinity();
  for (const Segment& edge : edges) {
    if (&edge == &*longest) continue;
    // Positions along the edge and depths below it; the ray from the middle runs at position zero.
    const double s = direction.dot(edge.start - middle), e = direction.dot(edge.end - middle);
    if ((s > 0 && e > 0) || (s < 0 && e < 0) || s == e) continue;
    const double fraction = s / (s - e);
    const double depth = inward.dot(edge.at(fraction) - middle);
    if (depth > 0) width = std::min(width, depth);
  }
  assert(width < std::numeric_limits<double>::infinity());
  return middle + 0.5 * width * inward;
}

}  // namespace bempd

#include "geometry/outline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace bempd {

Edge Outline::edge(int number) const {
  if (const auto found = curved.find(number); found != curved.end()) return found->second;
  std::size_t k = static_cast<std::size_t>(number);
  for (const auto& loop : loops) {
    if (k < loop.size()) return {loop[k], loop[(k + 1) % loop.size()]};
    k -= loop.size();
  }
  assert(false);
  return {Point::Zero(), Point::Zero()};
}

std::vector<Edge> edges_of(const Outline& outline) {
  std::vector<Edge> edges;
  for (const auto& loop : outline.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) edges.push_back({loop[k], loop[(k + 1) % loop.size()]});
  for (const auto& [number, edge] : outline.curved) edges[static_cast<std::size_t>(number)] = edge;
  return edges;
}

Box bounding_box(const Outline& outline) {
  Box box;
  for (const auto& loop : outline.loops)
    for (const Point& vertex : loop) box.extend(vertex);
  for (const auto& [number, edge] : outline.curved) box.extend(bounding_box(edge));
  return box;
}

double geometric_tolerance(const Box& box) {
  if (box.isEmpty()) return 0;
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max(1e-9 * box.diagonal().norm(), 4 * std::numeric_limits<double>::epsilon() * largest);
}

double signed_area(const std::vector<Edge>& loop) {
  // Coordinates are relative to the first vertex, so that there is no cancellation far from the origin.
  double twice = 0;
  const Point origin = loop.front().start;
  for (const Edge& edge : loop)
    for (int k = 0; k < edge.piece_count(); ++k) {
      const Arc& arc = edge.piece(k);
      twice += cross(arc.start - origin, arc.end - origin);
      if (arc.straight()) continue;
      const double radius = (arc.start - arc.centre()).norm();
      twice += radius * radius * (arc.sweep - std::sin(arc.sweep));
    }
  return 0.5 * twice;
}

double area(const Outline& outline) { return signed_area(edges_of(outline)); }

Location locate(const std::vector<Edge>& boundary, const Point& p, double tolerance) {
  bool inside = false;
  for (const Edge& edge : boundary) {
    // The lower bound of the distance is computed faster than the distance, but has some rounding error.
    const bool may_be_near = tolerance == 0 || least_distance(edge, p) <= 2 * tolerance;
    if (may_be_near && distance(edge, p) <= tolerance) return Location::on_boundary;
    // The even-odd rule decides; ray_crosses() counts a vertex once.
    if (ray_crosses(edge, p)) inside = !inside;
  }
  return inside ? Location::inside : Location::outside;
}

Location locate(const Outline& outline, const Point& p, double tolerance) {
  return locate(edges_of(outline), p, tolerance);
}

}  // namespace bempd

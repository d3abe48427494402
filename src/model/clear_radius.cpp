#include "model/clear_radius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/segment.hpp"

namespace bempd::model {

namespace {

// Sine of the largest angle, seen from the tip, between the tip's direction and a point of the crack behind it, up to
// which the crack counts as straight.
constexpr double straight_within = 0.1;

// Distance from a place to the free part of an edge: the part behind which no body of the same material continues.
// `joined` are the other parts, as ascending intervals of fractions of the edge.
double distance_to_free_part(const Edge& edge, const std::vector<std::pair<double, double>>& joined,
                             const Point& place) {
  if (joined.empty()) return distance(edge, place);
  double nearest = std::numeric_limits<double>::infinity(), from = 0;
  const auto add = [&](double to) {
    if (to <= from) return;
    nearest = std::min(nearest,
                       edge.straight() ? distance(Segment{edge.at(from), edge.at(to)}, place) : distance(edge, place));
  };
  for (const auto& [start, end] : joined) add(start), from = std::max(from, end);
  add(1);
  return nearest;
}

// Distance from the tip of a crack back to the crack's first bend or other end; less if a part of the crack behind the
// bend comes nearer to the tip.
double clear_of_own_crack(const std::vector<Point>& path, const ClearTip& tip) {
  double reached = 0;
  std::size_t k = path.size() - 1;
  for (; k > 0; --k) {
    const Point back = tip.place - path[k - 1];
    const double length = back.norm();
    if (length == 0) continue;
    if (back.dot(tip.direction) <= 0 || std::abs(cross(tip.direction, back)) > straight_within * length) break;
    reached = length;
  }
  for (; k > 0; --k)
    if (reached > 0) reached = std::min(reached, distance(Segment{path[k - 1], path[k]}, tip.place));
  return reached;
}

}  // namespace

double clear_radius(const scene::Scene& scene, const regions::Discretization& discretization,
                    const std::vector<std::vector<Point>>& paths, const ClearTip& tip) {
  double radius = std::numeric_limits<double>::infinity();
  for (const int id : scene.region_ids()) {
    const std::vector<Edge> edges = edges_of(scene.region(id).outline());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      std::vector<std::pair<double, double>> joined;
      for (const Contact& c : discretization.arrangement.contacts)
        if (c.region + 1 == id && c.edge == static_cast<int>(e) &&
            scene.material_of(id) == scene.material_of(c.other_region + 1))
          joined.emplace_back(c.from, c.to);
      radius = std::min(radius, distance_to_free_part(edges[e], joined, tip.place));
    }
  }
  for (std::size_t c = 0; c < paths.size(); ++c) {
    std::vector<Point> path = paths[c];
    if (path.size() < 2) continue;
    if (static_cast<int>(c) + 1 == tip.id.crack) {
      if (tip.id.end == 0) std::reverse(path.begin(), path.end());
      radius = std::min(radius, clear_of_own_crack(path, tip));
      continue;
    }
    radius = std::min(radius, polyline_distance(path, tip.place));
  }
  return radius;
}

}  // namespace bempd::model

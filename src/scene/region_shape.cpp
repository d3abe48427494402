#include "scene/region_shape.hpp"

#include <cmath>
#include <numbers>

#include "error.hpp"
#include "geometry/smooth_curve.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::scene {

namespace {

// Replaces an edge by the arc between its ends; a flat arc becomes a straight edge.
void bend(Region& region, int number, const Arc& arc, double tolerance) {
  Outline changed = region.outline();
  changed.curved.erase(number - 1);
  if (std::abs(arc.sagitta()) > 0.01 * tolerance) changed.curved.emplace(number - 1, Edge(arc));
  require_sound(changed);
  region.set_outline(std::move(changed));
}

}  // namespace

int RegionShape::add_hole(const std::vector<Point>& vertices, const std::vector<double>& bulges) {
  Outline changed = region_.outline();
  append_loop(changed, vertices, bulges);
  require(changed.curved.size() == region_.outline().curved.size() || region_.may_be_curved(), "region ", id_, " is ",
          region_.adjective(), "; the edges of its holes are straight");
  require_sound(changed);
  const int first_edge = region_.edge_count() + 1;
  region_.set_outline(std::move(changed));
  return first_edge;
}

int RegionShape::add_circular_hole(const Point& centre, double radius) {
  require(region_.may_be_curved(), "region ", id_, " is ", region_.adjective(), "; its holes are rectilinear");
  Outline changed = region_.outline();
  const int first_edge = region_.edge_count() + 1;
  append_circle(changed, centre, radius, true);
  require_sound(changed);
  region_.set_outline(std::move(changed));
  return first_edge;
}

void RegionShape::require_edge_to_bend(int edge) const {
  require_edge(region_, id_, edge);
  require(region_.may_be_curved(), "region ", id_, " is ", region_.adjective(), "; its edges are straight");
}

void RegionShape::set_arc(int number, const Point& between) {
  require_edge_to_bend(number);
  require(between.allFinite(), "the place is (", between.x(), ", ", between.y(),
          "); coordinates must be finite numbers");
  const Edge edge = region_.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region_.outline()));
  const bool at_an_end = (between - edge.start).norm() <= tolerance || (between - edge.end).norm() <= tolerance;
  const std::optional<Arc> arc = at_an_end ? std::nullopt : arc_through(edge.start, between, edge.end);
  require(arc.has_value(), "there is no arc from ", place_of(edge.start), " through ", place_of(between), " to ",
          place_of(edge.end), "; give a place on the arc about half way between the ends of the edge");
  bend(region_, number, *arc, tolerance);
}

void RegionShape::set_arc_about(int number, const Point& centre, double radius, bool clockwise) {
  require_edge_to_bend(number);
  require_circle(centre, radius);
  const Edge edge = region_.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region_.outline()));
  const Point from = edge.start - centre, to = edge.end - centre;
  require(std::abs(from.norm() - radius) <= tolerance && std::abs(to.norm() - radius) <= tolerance, "edge ", number,
          " of region ", id_, " begins ", from.norm(), " and ends ", to.norm(), " from the centre ", place_of(centre),
          ", but the radius is ", radius, "; both must be the radius up to ", tolerance,
          ": correct the vertices, the centre or the radius");
  const double turned = std::atan2(cross(from, to), from.dot(to)), whole = 2 * std::numbers::pi;
  const double sweep = clockwise ? (turned < 0 ? turned : turned - whole) : (turned > 0 ? turned : turned + whole);
  bend(region_, number, {edge.start, edge.end, sweep}, tolerance);
}

void RegionShape::set_smooth(int first_edge, int last_edge) {
  require_edge_to_bend(first_edge);
  require_edge_to_bend(last_edge);
  int loop_start = 1;
  const std::vector<Point>* loop = nullptr;
  for (const auto& candidate : region_.outline().loops) {
    loop = &candidate;
    if (first_edge < loop_start + static_cast<int>(candidate.size())) break;
    loop_start += static_cast<int>(candidate.size());
  }
  const int loop_end = loop_start + static_cast<int>(loop->size()) - 1;
  require(last_edge <= loop_end, "edges ", first_edge, " and ", last_edge,
          " belong to different loops of the outline; smooth each loop for itself (this one has edges ", loop_start,
          " .. ", loop_end, ")");
  const bool closed = first_edge == loop_start && last_edge == loop_end;
  require(closed || last_edge > first_edge, "edges ", first_edge, " .. ", last_edge,
          " have no common vertex; give at least two edges that follow each other, the smaller number first");
  std::vector<Point> points;
  for (int edge = first_edge; edge <= last_edge; ++edge) points.push_back((*loop)[edge - loop_start]);
  if (!closed) points.push_back(region_.edge(last_edge).end);
  const std::vector<Edge> edges = smooth_curve(points, closed);
  Outline changed = region_.outline();
  for (int edge = first_edge; edge <= last_edge; ++edge) {
    changed.curved.erase(edge - 1);
    if (const Edge& curve = edges[edge - first_edge]; !curve.straight()) changed.curved.emplace(edge - 1, curve);
  }
  require_sound(changed);
  region_.set_outline(std::move(changed));
}

void RegionShape::set_mesh(int edge, const EdgeMesh& mesh) {
  require_edge(region_, id_, edge);
  require(region_.has_elements(), "region ", id_, " is ", region_.adjective(),
          "; only edges of BEM regions have elements");
  region_.set_edge_mesh(edge, mesh);
}

}  // namespace bempd::scene

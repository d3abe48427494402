#include <cmath>
#include <numbers>

#include "error.hpp"
#include "geometry/smooth_curve.hpp"
#include "scene/outline_rules.hpp"
#include "scene/scene.hpp"

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

int Scene::add_hole(int region_id, const std::vector<Point>& vertices, const std::vector<double>& bulges) {
  Region& region = mutable_region(region_id);
  Outline changed = region.outline();
  append_loop(changed, vertices, bulges);
  require(changed.curved.size() == region.outline().curved.size() || region.may_be_curved(), "region ", region_id,
          " is ", region.adjective(), "; the edges of its holes are straight");
  require_sound(changed);
  const int first_edge = region.edge_count() + 1;
  region.set_outline(std::move(changed));
  return first_edge;
}

int Scene::add_circular_hole(int region_id, const Point& centre, double radius) {
  Region& region = mutable_region(region_id);
  require(region.may_be_curved(), "region ", region_id, " is ", region.adjective(), "; its holes are rectilinear");
  Outline changed = region.outline();
  const int first_edge = region.edge_count() + 1;
  append_circle(changed, centre, radius, true);
  require_sound(changed);
  region.set_outline(std::move(changed));
  return first_edge;
}

const Region& Scene::region_with_edge(int id, int edge) const {
  const Region& found = region(id);
  require(edge >= 1 && edge <= found.edge_count(), "edge ", edge, " does not exist; region ", id, " has edges 1 .. ",
          found.edge_count());
  return found;
}

Region& Scene::mutable_region_with_edge(int id, int edge) {
  region_with_edge(id, edge);
  return mutable_region(id);
}

Region& Scene::region_to_bend(int id, int edge) {
  Region& region = mutable_region_with_edge(id, edge);
  require(region.may_be_curved(), "region ", id, " is ", region.adjective(), "; its edges are straight");
  return region;
}

void Scene::set_edge_arc(int region_id, int number, const Point& between) {
  Region& region = region_to_bend(region_id, number);
  require(between.allFinite(), "the place is (", between.x(), ", ", between.y(),
          "); coordinates must be finite numbers");
  const Edge edge = region.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region.outline()));
  const bool at_an_end = (between - edge.start).norm() <= tolerance || (between - edge.end).norm() <= tolerance;
  const std::optional<Arc> arc = at_an_end ? std::nullopt : arc_through(edge.start, between, edge.end);
  require(arc.has_value(), "there is no arc from ", place_of(edge.start), " through ", place_of(between), " to ",
          place_of(edge.end), "; give a place on the arc about half way between the ends of the edge");
  bend(region, number, *arc, tolerance);
}

void Scene::set_edge_arc_about(int region_id, int number, const Point& centre, double radius, bool clockwise) {
  Region& region = region_to_bend(region_id, number);
  require_circle(centre, radius);
  const Edge edge = region.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region.outline()));
  const Point from = edge.start - centre, to = edge.end - centre;
  require(std::abs(from.norm() - radius) <= tolerance && std::abs(to.norm() - radius) <= tolerance, "edge ", number,
          " of region ", region_id, " begins ", from.norm(), " and ends ", to.norm(), " from the centre ",
          place_of(centre), ", but the radius is ", radius, "; both must be the radius up to ", tolerance,
          ": correct the vertices, the centre or the radius");
  const double turned = std::atan2(cross(from, to), from.dot(to)), whole = 2 * std::numbers::pi;
  const double sweep = clockwise ? (turned < 0 ? turned : turned - whole) : (turned > 0 ? turned : turned + whole);
  bend(region, number, {edge.start, edge.end, sweep}, tolerance);
}

void Scene::set_edges_smooth(int region_id, int first_edge, int last_edge) {
  Region& region = region_to_bend(region_id, first_edge);
  region_to_bend(region_id, last_edge);
  int loop_start = 1;
  const std::vector<Point>* loop = nullptr;
  for (const auto& candidate : region.outline().loops) {
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
  if (!closed) points.push_back(region.edge(last_edge).end);
  const std::vector<Edge> edges = smooth_curve(points, closed);
  Outline changed = region.outline();
  for (int edge = first_edge; edge <= last_edge; ++edge) {
    changed.curved.erase(edge - 1);
    if (const Edge& curve = edges[edge - first_edge]; !curve.straight()) changed.curved.emplace(edge - 1, curve);
  }
  require_sound(changed);
  region.set_outline(std::move(changed));
}

void Scene::set_edge_mesh(int region_id, int edge, const EdgeMesh& mesh) {
  Region& region = mutable_region_with_edge(region_id, edge);
  require(region.has_elements(), "region ", region_id, " is ", region.adjective(),
          "; only edges of BEM regions have elements");
  region.set_edge_mesh(edge, mesh);
}

}  // namespace bempd::scene

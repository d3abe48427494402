#include <cmath>
#include <numbers>

#include "error.hpp"
#include "geometry/smooth_curve.hpp"
#include "scene/outline_rules.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

namespace {

std::string place_of(const Point& p) { return text("(", p.x(), ", ", p.y(), ")"); }

}  // namespace

int Scene::add_hole(int region_id, const std::vector<Point>& vertices) {
  Region& region = mutable_region(region_id);
  require_points(vertices, "vertex");
  Outline changed = region.outline();
  changed.loops.push_back(vertices);
  require_sound(changed);
  const int first_edge = region.edge_count() + 1;
  region.set_outline(std::move(changed));
  return first_edge;
}

int Scene::add_circular_hole(int region_id, const Point& centre, double radius) {
  Region& region = mutable_region(region_id);
  require(region.has_elements(), "region ", region_id, " is ", region.adjective(), "; its holes are rectilinear");
  require(centre.allFinite(), "the centre is (", centre.x(), ", ", centre.y(), "); coordinates must be finite numbers");
  require(std::isfinite(radius) && radius > 0, "radius is ", radius, "; it must be > 0");
  Outline changed = region.outline();
  std::vector<Point> vertices;
  for (const Point& direction : {Point(1, 0), Point(0, -1), Point(-1, 0), Point(0, 1)})
    vertices.push_back(centre + radius * direction);
  changed.loops.push_back(vertices);
  const int first_edge = region.edge_count() + 1;
  for (int k = 0; k < 4; ++k) {
    const Arc quarter{vertices[k], vertices[(k + 1) % 4], -0.5 * std::numbers::pi};
    changed.curved.emplace(first_edge - 1 + k, Edge(quarter));
  }
  require_sound(changed);
  region.set_outline(std::move(changed));
  return first_edge;
}

Region& Scene::region_with_edge(int id, int edge, const char* purpose) {
  Region& region = mutable_region(id);
  require(region.has_elements(), "region ", id, " is ", region.adjective(), "; only edges of BEM regions ", purpose);
  require(edge >= 1 && edge <= region.edge_count(), "edge ", edge, " does not exist; region ", id, " has edges 1 .. ",
          region.edge_count());
  return region;
}

void Scene::set_edge_arc(int region_id, int number, const Point& between) {
  Region& region = region_with_edge(region_id, number, "can be arcs");
  require(between.allFinite(), "the place is (", between.x(), ", ", between.y(),
          "); coordinates must be finite numbers");
  const Edge edge = region.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region.outline()));
  const bool at_an_end = (between - edge.start).norm() <= tolerance || (between - edge.end).norm() <= tolerance;
  const std::optional<Arc> arc = at_an_end ? std::nullopt : arc_through(edge.start, between, edge.end);
  require(arc.has_value(), "there is no arc from ", place_of(edge.start), " through ", place_of(between), " to ",
          place_of(edge.end), "; give a place on the arc about half way between the ends of the edge");
  Outline changed = region.outline();
  changed.curved.erase(number - 1);
  if (std::abs(arc->sagitta()) > 0.01 * tolerance) changed.curved.emplace(number - 1, Edge(*arc));
  require_sound(changed);
  region.set_outline(std::move(changed));
}

void Scene::set_edges_smooth(int region_id, int first_edge, int last_edge) {
  Region& region = region_with_edge(region_id, first_edge, "can be smooth");
  region_with_edge(region_id, last_edge, "can be smooth");
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
  region_with_edge(region_id, edge, "have elements").set_edge_mesh(edge, mesh);
}

}  // namespace bempd::scene

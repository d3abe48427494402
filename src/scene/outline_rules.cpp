#include "scene/outline_rules.hpp"

#include <cmath>
#include <numbers>

#include "error.hpp"
#include "geometry/outline_check.hpp"

namespace bempd::scene {

void require_points(const std::vector<Point>& points, const char* what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(points[i].allFinite(), what, " ", i + 1, " is (", points[i].x(), ", ", points[i].y(),
            "); coordinates must be finite numbers");
  }
}

std::string place_of(const Point& p) { return text("(", p.x(), ", ", p.y(), ")"); }

namespace {

std::string describe_short_edge(const Outline& outline, int edge, const Point& where) {
  const double length = outline.edge(edge).length();
  if (length == 0) {
    return text("the outline repeats the vertex ", place_of(where), " (edge ", edge + 1,
                " has no length); give every vertex once and do not repeat the first at the end");
  }
  return text("edge ", edge + 1, " of the outline, at ", place_of(where), ", has the length ", length,
              "; places closer than ", geometric_tolerance(bempd::bounding_box(outline)),
              " count as one in a body of this size: leave out one of its ends");
}

// Whether a loop has the right orientation if its arcs are taken as straight. If it has, one of the arcs bulges over
// the opposite side.
bool arcs_turn_round(const Outline& outline, int loop) {
  std::vector<Edge> straight;
  const std::vector<Point>& vertices = outline.loops[static_cast<std::size_t>(loop)];
  for (std::size_t k = 0; k < vertices.size(); ++k)
    straight.emplace_back(vertices[k], vertices[(k + 1) % vertices.size()]);
  return (signed_area(straight) > 0) == (loop == 0);
}

std::string describe(const OutlineCheck& check, const Outline& outline) {
  const int a = check.edge_a + 1, b = check.edge_b + 1;
  switch (check.defect) {
    case OutlineDefect::none:
      return "";
    case OutlineDefect::not_finite:
      return text("vertex ", a, " is not a usable number; coordinates must be finite and below 1e75");
    case OutlineDefect::too_few_vertices:
      return "the outline has less than 3 vertices; give at least 3, without repeating the first at the end";
    case OutlineDefect::repeated_vertex:
      return describe_short_edge(outline, check.edge_a, check.where);
    case OutlineDefect::spike:
      return text("edge ", b, " of the outline runs back over edge ", a, " at ", place_of(check.where),
                  "; remove the spike");
    case OutlineDefect::self_crossing:
      return text(
          "edges ", a, " and ", b, " of the outline cross or touch at ", place_of(check.where),
          "; an outline must not cross itself (where edges are meant to be arcs, give their bulges together with "
          "the vertices)");
    case OutlineDefect::wrong_orientation:
      if (arcs_turn_round(outline, check.loop)) {
        return "an arc bulges across the outline to its other side; give a place on the arc that is closer to the edge";
      }
      return check.loop == 0
                 ? std::string("the outline runs clockwise; give its vertices counter-clockwise (in reverse order)")
                 : std::string("the hole runs counter-clockwise; give its vertices clockwise (in reverse order)");
    case OutlineDefect::hole_outside:
      return text("the hole is not inside the outline, see ", place_of(check.where),
                  "; a hole must lie inside without touching the outer loop");
    case OutlineDefect::holes_overlap:
      return text("the hole overlaps or touches another hole at ", place_of(check.where), "; keep holes apart");
  }
  return "";
}

}  // namespace

void require_sound(const Outline& outline) {
  const OutlineCheck check = check_outline(outline);
  require(check.sound(), describe(check, outline));
}

void require_circle(const Point& centre, double radius) {
  require(centre.allFinite(), "the centre is (", centre.x(), ", ", centre.y(), "); coordinates must be finite numbers");
  require(std::isfinite(radius) && radius > 0, "radius is ", radius, "; it must be > 0");
}

void append_loop(Outline& outline, const std::vector<Point>& vertices, const std::vector<double>& bulges) {
  require_points(vertices, "vertex");
  const int first = static_cast<int>(edges_of(outline).size());
  for (std::size_t k = 0; k < bulges.size(); ++k) {
    require(std::isfinite(bulges[k]), "bulge ", k + 1, " is ", bulges[k],
            "; it must be a finite number: the tangent of a quarter of the angle that the edge turns, 0 for a straight "
            "edge");
    if (bulges[k] == 0) continue;
    const Arc arc{vertices[k], vertices[(k + 1) % vertices.size()], 4 * std::atan(bulges[k])};
    outline.curved.emplace(first + static_cast<int>(k), Edge(arc));
  }
  outline.loops.push_back(vertices);
}

void append_circle(Outline& outline, const Point& centre, double radius, bool clockwise) {
  require_circle(centre, radius);
  const double turn = clockwise ? -1 : 1;
  std::vector<Point> vertices;
  for (const Point& direction : {Point(1, 0), Point(0, turn), Point(-1, 0), Point(0, -turn)})
    vertices.push_back(centre + radius * direction);
  int edge = static_cast<int>(edges_of(outline).size());
  for (int k = 0; k < 4; ++k) {
    const Arc quarter{vertices[k], vertices[(k + 1) % 4], turn * 0.5 * std::numbers::pi};
    outline.curved.emplace(edge++, Edge(quarter));
  }
  outline.loops.push_back(std::move(vertices));
}

}  // namespace bempd::scene

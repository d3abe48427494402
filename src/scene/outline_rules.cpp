#include "scene/outline_rules.hpp"

#include "error.hpp"
#include "geometry/outline_check.hpp"

namespace bempd::scene {

void require_points(const std::vector<Point>& points, const char* what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(points[i].allFinite(), what, " ", i, " is (", points[i].x(), ", ", points[i].y(),
            "); coordinates must be finite numbers");
  }
}

namespace {

std::string place_of(const Point& p) { return text("(", p.x(), ", ", p.y(), ")"); }

std::string describe(const OutlineCheck& check) {
  const int a = check.edge_a + 1, b = check.edge_b + 1;
  switch (check.defect) {
    case OutlineDefect::none:
      return "";
    case OutlineDefect::not_finite:
      return text("vertex ", check.edge_a, " is not a usable number; coordinates must be finite and below 1e75");
    case OutlineDefect::too_few_vertices:
      return "the outline has less than 3 vertices; give at least 3, without repeating the first at the end";
    case OutlineDefect::repeated_vertex:
      return text("the outline repeats the vertex ", place_of(check.where), " (edge ", a,
                  " has no length); give every vertex once and do not repeat the first at the end");
    case OutlineDefect::spike:
      return text("edge ", b, " of the outline runs back over edge ", a, " at ", place_of(check.where),
                  "; remove the spike");
    case OutlineDefect::self_crossing:
      return text("edges ", a, " and ", b, " of the outline cross or touch at ", place_of(check.where),
                  "; an outline must not cross itself");
    case OutlineDefect::wrong_orientation:
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
  require(check.sound(), describe(check));
}

}  // namespace bempd::scene

#include "scene/scene.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "error.hpp"
#include "geometry/outline_check.hpp"
#include "geometry/smooth_curve.hpp"
#include "pd/critical_stretch.hpp"

namespace bempd::model {

namespace {

// More elements or cells than this in one region is a mistyped length: no machine holds the operators.
constexpr double most_elements = 1e6;
constexpr double most_cells = 1e9;

void require_points(const std::vector<Point>& points, const char* what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(points[i].allFinite(), what, " ", i, " is (", points[i].x(), ", ", points[i].y(),
            "); coordinates must be finite numbers");
  }
}

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

void require_sound(const Outline& outline) {
  const OutlineCheck check = check_outline(outline);
  require(check.sound(), describe(check));
}

std::string list_of(const std::vector<double>& values) {
  std::string list;
  for (std::size_t i = 0; i < values.size(); ++i) list += text(i == 0 ? "" : " or ", values[i]);
  return list;
}

LatticeOutline require_lattice(const Outline& outline, double spacing) {
  LatticeFit fit = fit_lattice(outline, spacing);
  const std::string advice = fit.suggestions.empty()
                                 ? std::string("; choose one that divides all edges and offsets of holes")
                                 : "; try " + list_of(fit.suggestions);
  switch (fit.misfit) {
    case LatticeMisfit::none:
      break;
    case LatticeMisfit::bad_spacing:
      require(false, "spacing ", spacing,
              " is not a usable lattice spacing for this outline; it must be positive, and large enough for cells to "
              "be counted");
      break;
    case LatticeMisfit::oblique_edge:
      require(false, "edge ", fit.edge + 1,
              " is parallel to neither axis; the outline of a peridynamic region must be rectilinear");
      break;
    case LatticeMisfit::indivisible_edge:
      require(false, "spacing ", spacing, " does not divide edge ", fit.edge + 1, " of length ", fit.length, advice);
      break;
    case LatticeMisfit::shifted_hole:
      require(false, "the hole is ", fit.length,
              " away from the first vertex along an axis, which is not a whole number of spacings ", spacing, advice);
      break;
  }
  return fit.outline;
}

void require_element_length(double element_length, double longest) {
  require(std::isfinite(element_length) && element_length > 0, "element_length is ", element_length,
          "; it must be > 0");
  require(longest / element_length <= most_elements, "element_length ", element_length, " would need ",
          longest / element_length, " elements; the limit is ", most_elements, ": choose a longer one");
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (const Edge& edge : edges_of(outline)) sum += edge.length();
  return sum;
}

}  // namespace

double Material::critical_stretch_for(double horizon, bool as_printed) const {
  if (critical_stretch > 0) return critical_stretch;
  if (fracture_energy > 0) {
    if (as_printed) {
      require(
          elasticity.state == PlaneState::stress,
          "the option critical_stretch = printed stands for a formula of plane stress; choose exact in plane strain");
      return pd::printed_critical_stretch(fracture_energy, elasticity.young_modulus, horizon);
    }
    return pd::critical_stretch(fracture_energy, elasticity.young_modulus, horizon, elasticity.state);
  }
  return std::numeric_limits<double>::infinity();
}

int Region::edge_count() const {
  std::size_t count = 0;
  for (const auto& loop : outline.loops) count += loop.size();
  return static_cast<int>(count);
}

int Scene::add_material(const Material& material) {
  const PlaneElasticity& e = material.elasticity;
  require(std::isfinite(e.young_modulus) && e.young_modulus > 0, "young_modulus is ", e.young_modulus,
          "; it must be > 0");
  require(std::isfinite(e.poisson_ratio) && e.poisson_ratio > -1 && e.poisson_ratio <= 0.5, "poisson_ratio is ",
          e.poisson_ratio, "; it must be above -1 and at most 1/2");
  require(std::isfinite(e.thickness) && e.thickness > 0, "thickness is ", e.thickness, "; it must be > 0");
  require(std::isfinite(material.critical_stretch) && material.critical_stretch >= 0, "critical_stretch is ",
          material.critical_stretch, "; it must be > 0, or 0 for not given");
  require(std::isfinite(material.fracture_energy) && material.fracture_energy >= 0, "fracture_energy is ",
          material.fracture_energy, "; it must be > 0, or 0 for not given");
  require(material.critical_stretch == 0 || material.fracture_energy == 0,
          "both critical_stretch and fracture_energy are given; give one and set the other to 0");
  if (!materials_.empty()) {
    require(materials_.front().elasticity.state == e.state,
            "this material's plane differs from the model's first material; a model is either in plane stress or in "
            "plane strain");
  }
  materials_.push_back(material);
  return static_cast<int>(materials_.size());
}

int Scene::add_boundary_region(int material_id, const std::vector<Point>& vertices, double element_length) {
  material(material_id);
  require_points(vertices, "vertex");
  Region region;
  region.kind = RegionKind::boundary_elements;
  region.material = material_id;
  region.outline.loops = {vertices};
  require_sound(region.outline);
  require_element_length(element_length, perimeter(region.outline));
  region.element_length = element_length;
  regions_.push_back(std::move(region));
  return static_cast<int>(regions_.size());
}

int Scene::add_lattice_region(int material_id, const std::vector<Point>& vertices, double spacing, int horizon_ratio) {
  const PlaneElasticity& elasticity = material(material_id).elasticity;
  const double needed = bond_based_poisson_ratio(elasticity.state);
  require(std::abs(elasticity.poisson_ratio - needed) < 1e-9, "material ", material_id, " has Poisson's ratio ",
          elasticity.poisson_ratio, "; bond-based peridynamics needs ",
          elasticity.state == PlaneState::stress ? "1/3 in plane stress" : "1/4 in plane strain");
  require(horizon_ratio >= 2 && horizon_ratio <= 8, "horizon_ratio is ", horizon_ratio, "; it must be 2 .. 8");
  require(std::isfinite(spacing) && spacing > 0, "spacing is ", spacing, "; it must be > 0");
  require_points(vertices, "vertex");
  require(vertices.size() >= 4, "the outline has ", vertices.size(),
          " vertices; a rectilinear outline has at least 4, without repeating the first at the end");
  Region region;
  region.kind = RegionKind::peridynamics;
  region.material = material_id;
  region.outline.loops = {vertices};
  require_sound(region.outline);
  const double cells = area(region.outline) / (spacing * spacing);
  require(cells <= most_cells, "spacing ", spacing, " would need ", cells, " cells; the limit is ", most_cells,
          ": choose a larger one");
  region.horizon_ratio = horizon_ratio;
  region.lattice = require_lattice(region.outline, spacing);
  regions_.push_back(std::move(region));
  return static_cast<int>(regions_.size());
}

int Scene::add_hole(int region_id, const std::vector<Point>& vertices) {
  Region& region = mutable_region(region_id);
  require_points(vertices, "vertex");
  Region changed = region;
  changed.outline.loops.push_back(vertices);
  require_sound(changed.outline);
  if (region.kind == RegionKind::peridynamics)
    changed.lattice = require_lattice(changed.outline, region.lattice.spacing);
  const int first_edge = region.edge_count() + 1;
  region = std::move(changed);
  return first_edge;
}

int Scene::add_circular_hole(int region_id, const Point& centre, double radius) {
  Region& region = mutable_region(region_id);
  require(region.kind == RegionKind::boundary_elements, "region ", region_id,
          " is peridynamic; its holes are rectilinear");
  require(centre.allFinite(), "the centre is (", centre.x(), ", ", centre.y(), "); coordinates must be finite numbers");
  require(std::isfinite(radius) && radius > 0, "radius is ", radius, "; it must be > 0");
  Region changed = region;
  std::vector<Point> vertices;
  for (const Point& direction : {Point(1, 0), Point(0, -1), Point(-1, 0), Point(0, 1)})
    vertices.push_back(centre + radius * direction);
  changed.outline.loops.push_back(vertices);
  const int first_edge = region.edge_count() + 1;
  for (int k = 0; k < 4; ++k) {
    const Arc quarter{vertices[k], vertices[(k + 1) % 4], -0.5 * std::numbers::pi};
    changed.outline.curved.emplace(first_edge - 1 + k, Edge(quarter));
  }
  require_sound(changed.outline);
  region = std::move(changed);
  return first_edge;
}

Region& Scene::region_with_edge(int id, int edge, const char* purpose) {
  Region& region = mutable_region(id);
  require(region.kind == RegionKind::boundary_elements, "region ", id, " is peridynamic; only edges of BEM regions ",
          purpose);
  require(edge >= 1 && edge <= region.edge_count(), "edge ", edge, " does not exist; region ", id, " has edges 1 .. ",
          region.edge_count());
  return region;
}

void Scene::set_edge_arc(int region_id, int number, const Point& between) {
  Region& region = region_with_edge(region_id, number, "can be arcs");
  require(between.allFinite(), "the place is (", between.x(), ", ", between.y(),
          "); coordinates must be finite numbers");
  const Edge edge = region.edge(number);
  const double tolerance = geometric_tolerance(bempd::bounding_box(region.outline));
  const bool at_an_end = (between - edge.start).norm() <= tolerance || (between - edge.end).norm() <= tolerance;
  const std::optional<Arc> arc = at_an_end ? std::nullopt : arc_through(edge.start, between, edge.end);
  require(arc.has_value(), "there is no arc from ", place_of(edge.start), " through ", place_of(between), " to ",
          place_of(edge.end), "; give a place on the arc about half way between the ends of the edge");
  Region changed = region;
  changed.outline.curved.erase(number - 1);
  if (std::abs(arc->sagitta()) > 0.01 * tolerance) changed.outline.curved.emplace(number - 1, Edge(*arc));
  require_sound(changed.outline);
  require_element_length(region.element_length, perimeter(changed.outline));
  region = std::move(changed);
}

void Scene::set_edges_smooth(int region_id, int first_edge, int last_edge) {
  Region& region = region_with_edge(region_id, first_edge, "can be smooth");
  region_with_edge(region_id, last_edge, "can be smooth");
  int loop_start = 1;
  const std::vector<Point>* loop = nullptr;
  for (const auto& candidate : region.outline.loops) {
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
  Region changed = region;
  for (int edge = first_edge; edge <= last_edge; ++edge) {
    changed.outline.curved.erase(edge - 1);
    if (const Edge& curve = edges[edge - first_edge]; !curve.straight())
      changed.outline.curved.emplace(edge - 1, curve);
  }
  require_sound(changed.outline);
  require_element_length(region.element_length, perimeter(changed.outline));
  region = std::move(changed);
}

void Scene::set_edge_mesh(int region_id, int edge, const EdgeMesh& mesh) {
  Region& region = region_with_edge(region_id, edge, "have elements");
  require_element_length(mesh.element_length, region.edge(edge).length());
  require(std::isfinite(mesh.grading) && mesh.grading >= 1 && mesh.grading <= 4, "grading is ", mesh.grading,
          "; it must lie between 1 (equal elements) and 4");
  region.edge_mesh[edge] = mesh;
}

int Scene::add_crack(const std::vector<Point>& points) {
  require(points.size() >= 2, "the crack has ", points.size(), " points; give at least 2");
  require_points(points, "point");
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    require(points[i] != points[i + 1], "points ", i, " and ", i + 1,
            " of the crack are the same; give distinct points");
  }
  cracks_.push_back({points});
  return static_cast<int>(cracks_.size());
}

const Material& Scene::material(int id) const {
  require(id >= 1 && id <= static_cast<int>(materials_.size()), "material ", id, " does not exist; ",
          materials_.empty() ? text("add a material first") : text("ids run from 1 to ", materials_.size()));
  return materials_[id - 1];
}

const Region& Scene::region(int id) const {
  require(id >= 1 && id <= static_cast<int>(regions_.size()), "region ", id, " does not exist; ",
          regions_.empty() ? text("add a region first") : text("ids run from 1 to ", regions_.size()));
  return regions_[id - 1];
}

Region& Scene::mutable_region(int id) {
  region(id);
  return regions_[id - 1];
}

Box Scene::bounding_box() const {
  Box box;
  for (const Region& region : regions_) box.extend(bempd::bounding_box(region.outline));
  return box;
}

}  // namespace bempd::model

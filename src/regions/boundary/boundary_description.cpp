#include "regions/boundary/boundary_description.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "geometry/coarse_sizes.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/scheme.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::regions {

namespace {

// Largest number of elements in a region, or on one edge. No machine holds the operators of more elements, so a larger
// number comes from a mistyped length.
constexpr double most_on_an_edge = 1e6;

void require_element_length(double element_length, double longest) {
  require(std::isfinite(element_length) && element_length > 0, "element_length is ", element_length,
          "; it must be > 0");
  require(longest / element_length <= most_on_an_edge, "element_length ", element_length, " would need ",
          longest / element_length, " elements; the limit is ", most_on_an_edge, ": choose a longer one");
}

// Smallest length of an element relative to its edge. Integrals over shorter elements are within rounding.
constexpr double shortest_element = 1e-9;

// Length of the shortest element of an edge relative to the edge, for `count` elements whose lengths grow by the factor
// `grading` from element to element, from both ends of the edge to its middle.
double shortest_share(double count, double grading) {
  // Each half of the edge has elements with the relative lengths 1, g, g^2, ..., where g is `grading`.
  const double half = std::floor(0.5 * count), rest = count - 2 * half;
  const double sum = grading > 1 ? (std::pow(grading, half) - 1) / (grading - 1) : half;
  return 1 / (2 * sum + rest * std::pow(grading, half));
}

void require_long_elements(int edge, double length, const scene::EdgeMesh& mesh) {
  const double count = std::max(1.0, std::ceil(length / mesh.element_length * (1 - 1e-9)));
  const double share = shortest_share(count, mesh.grading);
  if (share >= shortest_element) return;
  double allowed = 1, refused = mesh.grading;
  while (refused - allowed > 1e-3) {
    const double middle = 0.5 * (allowed + refused);
    (shortest_share(count, middle) < shortest_element ? refused : allowed) = middle;
  }
  fail(Failure::argument, "element_length ", mesh.element_length, " and grading ", mesh.grading, " give edge ", edge,
       " ", count, " elements, the shortest ", share, " of its length; elements must not be shorter than ",
       shortest_element, " of their edge: choose a grading of at most ", std::floor(100 * allowed) / 100,
       ", or longer elements");
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (const Edge& edge : edges_of(outline)) sum += edge.length();
  return sum;
}

Outline checked(Outline outline) {
  scene::require_sound(outline);
  return outline;
}

}  // namespace

BoundaryDescription::BoundaryDescription(int material, Outline outline, double element_length)
    : Region(material, checked(std::move(outline))), element_length_(element_length) {
  require_element_length(element_length, perimeter(this->outline()));
}

BoundaryDescription::BoundaryDescription(int material, Outline outline)
    : Region(material, checked(std::move(outline))),
      element_length_(coarsest_element(this->outline())),
      is_body_(true) {}

void BoundaryDescription::set_outline(Outline changed) {
  const double length = is_body_ ? coarsest_element(changed) : element_length_;
  require_element_length(length, perimeter(changed));
  const std::vector<Edge> edges = edges_of(changed);
  for (const auto& [edge, mesh] : own_mesh_) {
    require_element_length(mesh.element_length, edges[edge - 1].length());
    require_long_elements(edge, edges[edge - 1].length(), mesh);
  }
  take_outline(std::move(changed));
  element_length_ = length;
}

void BoundaryDescription::cut_out(const std::vector<std::vector<Point>>& loops, double element_length) {
  Outline whole = outline(), changed = outline();
  const int edges = edge_count();
  for (const std::vector<Point>& loop : loops) changed.loops.emplace_back(loop.rbegin(), loop.rend());
  scene::require_sound(changed);
  set_outline(std::move(changed));
  whole_ = std::move(whole), whole_edges_ = edges;
  for (int edge = edges + 1; edge <= edge_count(); ++edge) own_mesh_[edge] = {element_length, 1};
}

void BoundaryDescription::fill_cut_outs() {
  if (!whole_) return;
  own_mesh_.erase(own_mesh_.upper_bound(whole_edges_), own_mesh_.end());
  take_outline(std::move(*whole_));
  whole_.reset();
}

void BoundaryDescription::exchange_cut_outs(BoundaryDescription& other) noexcept {
  exchange_outlines(other);
  std::swap(element_length_, other.element_length_);
  own_mesh_.swap(other.own_mesh_);
  whole_.swap(other.whole_);
  std::swap(whole_edges_, other.whole_edges_);
}

void BoundaryDescription::set_edge_mesh(int edge, const scene::EdgeMesh& mesh) {
  require_element_length(mesh.element_length, this->edge(edge).length());
  require(std::isfinite(mesh.grading) && mesh.grading >= 1 && mesh.grading <= 4, "grading is ", mesh.grading,
          "; it must lie between 1 (equal elements) and 4");
  require_long_elements(edge, this->edge(edge).length(), mesh);
  own_mesh_[edge] = mesh;
}

scene::EdgeMesh BoundaryDescription::edge_mesh(int edge) const {
  const auto found = own_mesh_.find(edge);
  return found != own_mesh_.end() ? found->second : scene::EdgeMesh{element_length_, 1.0};
}

void BoundaryDescription::add_size(scene::SizeEstimate& size) const {
  double elements = 0;
  for (int edge = 1; edge <= edge_count(); ++edge)
    elements += std::ceil(this->edge(edge).length() / edge_mesh(edge).element_length);
  size.elements += elements;
  size.bytes += least_memory_of_region(elements);
}

void BoundaryDescription::identify(Hash& hash) const {
  Region::identify(hash);
  if (is_body_) {
    hash.add(std::string_view("body"));
  } else {
    hash.add(element_length_);
  }
  hash.add(own_mesh_.size());
  for (const auto& [edge, mesh] : own_mesh_) {
    hash.add(edge);
    hash.add(mesh.element_length);
    hash.add(mesh.grading);
  }
}

std::unique_ptr<regions::Region> BoundaryDescription::build(int id, const Preparation& preparation) const {
  return preparation.scheme.boundary_region(id, preparation.scene.material(material()));
}

BoundaryDescription* boundary_in(scene::Scene& scene, int region) {
  return dynamic_cast<BoundaryDescription*>(const_cast<scene::Region*>(&scene.region(region)));
}

bool is_body(const scene::Region& region) {
  const auto* boundary = dynamic_cast<const BoundaryDescription*>(&region);
  return boundary && boundary->is_body();
}

bool has_bodies(const scene::Scene& scene) {
  const std::vector<int> ids = scene.region_ids();
  return std::any_of(ids.begin(), ids.end(), [&](int id) { return is_body(scene.region(id)); });
}

int halvings_of(const scene::Region& region) {
  const auto* boundary = dynamic_cast<const BoundaryDescription*>(&region);
  return boundary ? boundary->halvings() : 0;
}

Refinement refine(scene::Scene& scene, const Refinement& refinement) noexcept {
  Refinement before;
  for (int id = 1; id <= scene.region_count(); ++id) {
    auto* const boundary = dynamic_cast<BoundaryDescription*>(scene.region_or_null(id));
    if (!boundary) continue;
    before = boundary->refinement();
    boundary->refine(refinement);
  }
  return before;
}

int add_boundary_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double element_length,
                        const std::vector<double>& bulges) {
  scene.material(material);
  Outline outline;
  scene::append_loop(outline, vertices, bulges);
  return scene.add_region(std::make_unique<BoundaryDescription>(material, std::move(outline), element_length));
}

int add_body(scene::Scene& scene, int material, const std::vector<Point>& vertices, const std::vector<double>& bulges) {
  scene.material(material);
  Outline outline;
  scene::append_loop(outline, vertices, bulges);
  return scene.add_region(std::make_unique<BoundaryDescription>(material, std::move(outline)));
}

int add_boundary_disc(scene::Scene& scene, int material, const Point& centre, double radius, double element_length) {
  scene.material(material);
  Outline outline;
  scene::append_circle(outline, centre, radius, false);
  return scene.add_region(std::make_unique<BoundaryDescription>(material, std::move(outline), element_length));
}

}  // namespace bempd::regions

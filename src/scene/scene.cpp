#include "scene/scene.hpp"

#include <limits>

#include "error.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::scene {

namespace {

void require_added(int id, std::size_t count, const char* what) {
  require(id >= 1 && id <= static_cast<int>(count), what, " ", id, " does not exist; ",
          count == 0 ? text("add a ", what, " first") : text("ids run from 1 to ", count));
}

}  // namespace

int Scene::add_material(const Material& material) {
  material.check();
  if (!materials_.empty()) {
    require(materials_.front().elasticity.state == material.elasticity.state,
            "this material's plane differs from the model's first material; a model is either in plane stress or in "
            "plane strain");
  }
  materials_.push_back(material);
  return static_cast<int>(materials_.size());
}

int Scene::add_region(std::unique_ptr<Region> region) {
  material(region->material());
  require_no_overlap(*region);
  regions_.push_back(std::move(region));
  return static_cast<int>(regions_.size());
}

int Scene::add_crack(const std::vector<Point>& points) {
  require(points.size() >= 2, "the crack has ", points.size(), " points; give at least 2");
  require_points(points, "point");
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    require(points[i] != points[i + 1], "points ", i + 1, " and ", i + 2,
            " of the crack are the same; give distinct points");
  }
  require_possible_crack(points);
  cracks_.push_back({points, 0, 0});
  return static_cast<int>(cracks_.size());
}

const Material& Scene::material(int id) const {
  require_added(id, materials_.size(), "material");
  return materials_[id - 1];
}

const Region& Scene::region(int id) const {
  require_added(id, regions_.size(), "region");
  require(regions_[id - 1] != nullptr, "region ", id, " was removed");
  return *regions_[id - 1];
}

const Region& Scene::region_with_edge(int id, int edge) const {
  require_edge(region(id), id, edge);
  return region(id);
}

std::vector<int> Scene::region_ids() const {
  std::vector<int> ids;
  for (int id = 1; id <= region_count(); ++id)
    if (regions_[id - 1]) ids.push_back(id);
  return ids;
}

Region& Scene::mutable_region(int id) { return const_cast<Region&>(region(id)); }

bool contains(const Scene& scene, int region, const Point& place, double tolerance) {
  return locate(scene.region(region).outline(), place, tolerance) != Location::outside;
}

bool has_inside(const Scene& scene, int region, const Point& place, double tolerance) {
  return locate(scene.region(region).outline(), place, tolerance) == Location::inside;
}

int region_at(const Scene& scene, const Point& place, double tolerance) {
  for (const int id : scene.region_ids())
    if (contains(scene, id, place, tolerance)) return id;
  return 0;
}

int crack_nearest(const std::vector<std::vector<Point>>& paths, const Point& place) {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < paths.size(); ++c)
    if (const double away = polyline_distance(paths[c], place); away < least)
      least = away, nearest = static_cast<int>(c) + 1;
  return nearest;
}

void exchange_parts(Scene& scene, std::vector<std::unique_ptr<Region>>& other, int count) noexcept {
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) scene.regions_[k].swap(other[k]);
  scene.regions_.swap(other);
}

std::vector<int> with_parts(const Scene& scene, int region) {
  std::vector<int> ids;
  for (const int id : scene.region_ids())
    if (id == region || scene.region(id).part_of() == region) ids.push_back(id);
  return ids;
}

Box Scene::bounding_box() const {
  Box box;
  for (int id : region_ids()) box.extend(bempd::bounding_box(region(id).outline()));
  return box;
}

}  // namespace bempd::scene

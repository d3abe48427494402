#pragma once

#include <memory>
#include <span>
#include <vector>

#include "scene/condition.hpp"
#include "scene/material.hpp"
#include "scene/region_shape.hpp"
#include "scene/scene_values.hpp"

namespace bempd::scene {

struct Crack {
  std::vector<Point> points;  // empty: the crack was removed
  // Numbers of points that growth has added at the crack's start and end.
  int grown_at_start = 0, grown_at_end = 0;
  bool has_begun = false;  // the crack began in the run, and the host has given no point of it

  bool operator==(const Crack&) const = default;
  std::span<const Point> given() const {
    if (has_begun) return {};
    return std::span(points).subspan(static_cast<std::size_t>(grown_at_start),
                                     points.size() - static_cast<std::size_t>(grown_at_start + grown_at_end));
  }
  // Length by which an end (0: first point, 1: last point) has grown [m].
  double grown(int end) const;
};

// Scene as the host described it. The id of an object is its position in the list of its kind plus 1. A removed object
// leaves its position empty, so that the ids of other objects do not change.
class Scene {
 public:
  int add_material(const Material& material);
  int add_region(std::unique_ptr<Region> region);
  RegionShape shape_of(int region) { return {mutable_region(region), region}; }
  void set_toughness(int region, std::vector<Point> places, std::vector<double> fracture_energies);
  Material& mutable_material(int id) { return const_cast<Material&>(material(id)); }
  int add_crack(const std::vector<Point>& points);
  // Replaces all cracks, for instance by the same cracks with their growth, and cracks that have begun in the run.
  void set_cracks(std::vector<Crack> cracks) { cracks_ = std::move(cracks); }
  int add_support(Condition condition);
  int add_load(Condition condition);
  // Gives a support or load (`what`, `id`) new values: as many samples as at its creation, or values at any places.
  void set_values(Condition& condition, const char* what, int id, SampledValues values);
  void set_values(Condition& condition, const char* what, int id, PlacedValues values);
  // Values of all supports and loads.
  SceneValues values() const;
  // Swaps the values of all supports and loads with `values`.
  void exchange_values(SceneValues& values) noexcept;
  // Runs `body` with `values` as the values of all supports and loads, and returns its result. The scene's own values
  // are restored afterwards.
  template <class Body>
  auto under(SceneValues& values, const Body& body) {
    struct Exchange {
      Scene& scene;
      SceneValues& values;
      Exchange(Scene& of, SceneValues& with) : scene(of), values(with) { scene.exchange_values(values); }
      ~Exchange() { scene.exchange_values(values); }
    } exchange(*this, values);
    return body();
  }

  // Removes a region. Throws Error (argument) while supports or loads act on the region.
  void remove_region(int id);
  void remove_crack(int id);
  void remove_support(int id);
  void remove_load(int id);

  const Material& material(int id) const;
  const Region& region(int id) const;
  int region_count() const { return static_cast<int>(regions_.size()); }  // with removed ones
  std::vector<int> region_ids() const;                                    // ids of regions that were not removed
  const Material& material_of(int region_id) const { return material(region(region_id).material()); }
  const Crack& crack(int id) const;
  const std::vector<Crack>& cracks() const { return cracks_; }
  const std::vector<Condition>& supports() const { return supports_; }
  const std::vector<Condition>& loads() const { return loads_; }
  const Condition& support(int id) const;
  const Condition& load(int id) const;
  Condition& support(int id);
  Condition& load(int id);
  // Region number `id`. Throws Error (argument) if the region does not have the edge.
  const Region& region_with_edge(int id, int edge) const;

  // Bounding box of the whole scene.
  Box bounding_box() const;

  // Region number `id`; null if it was removed.
  const Region* region_or_null(int id) const noexcept { return regions_[static_cast<std::size_t>(id) - 1].get(); }
  Region* region_or_null(int id) noexcept { return regions_[static_cast<std::size_t>(id) - 1].get(); }
  // Exchanges all regions after the first `count` regions, of which they are parts, for the entries of `other` after
  // its first `count` entries, which are null.
  friend void exchange_parts(Scene& scene, std::vector<std::unique_ptr<Region>>& other, int count) noexcept;

 private:
  Region& mutable_region(int id);
  void check_condition(const Condition& condition, bool is_support) const;
  // Checks for defects that no later call can repair (scene_checks.cpp). Other defects are found when the scene is
  // prepared.
  void require_no_overlap(const Region& added) const;
  void require_possible_crack(const std::vector<Point>& points) const;

  std::vector<Material> materials_;
  std::vector<std::unique_ptr<Region>> regions_;
  std::vector<Crack> cracks_;
  std::vector<Condition> supports_, loads_;
};

// Whether a region contains a place, be it on the outline.
bool contains(const Scene& scene, int region, const Point& place, double tolerance);
// Whether a place lies in a region and not on its outline.
bool has_inside(const Scene& scene, int region, const Point& place, double tolerance);
// Id of the first region that contains a place; 0 if none does.
int region_at(const Scene& scene, const Point& place, double tolerance);

// Id of the crack whose path is nearest to a place; 0 if no crack has a path.
int crack_nearest(const std::vector<std::vector<Point>>& paths, const Point& place);

// Ids of a region and of its parts.
std::vector<int> with_parts(const Scene& scene, int region);

// Sets a function of the host for the fracture energy of a material [J/m^2].
void set_resistance_function(Scene& scene, int material, crack::HostResistance::Function function);
// Sets fracture energies of a material [J/m^2] by the growth of a tip [m] (R-curve).
void set_resistance_curve(Scene& scene, int material, std::vector<double> extensions, std::vector<double> energies);
// Sets fracture energies of a material [J/m^2] by the direction of growth [rad].
void set_resistance_directions(Scene& scene, int material, std::vector<double> angles, std::vector<double> energies);

}  // namespace bempd::scene

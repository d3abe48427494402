#include "regions/places/heated_region.hpp"

#include <cmath>

#include "error.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

void HeatedRegion::check(const scene::Scene& scene) const { scene.region(region_); }

std::vector<PlacedNode> HeatedRegion::held_nodes(const scene::Scene&, const Discretization&, int support) const {
  fail(Failure::argument, "support ", support + 1, " heats region ", region_,
       "; supports hold edges and points: give it as a load");
}

void HeatedRegion::add_load(const scene::Scene& scene, const Discretization&, int load,
                            DofConditions& conditions) const {
  const double expansion = scene.material_of(region_).expansion_in_plane();
  const scene::Condition condition = scene.loads()[load];
  const auto strain = [expansion, condition, load](const Point& place) {
    const scene::BoundaryValue value = condition.acting_value(place, 0.0);
    require(std::isfinite(value.constant.x()) && std::isfinite(value.proportional.x()), "load ", load + 1,
            " has a temperature that is not a finite number at (", place.x(), ", ", place.y(), ")");
    return Eigen::Vector2d(expansion * value.constant.x(), expansion * value.proportional.x());
  };
  for (const int id : with_parts(scene, region_)) conditions.swelling[id].emplace_back(strain);
}

}  // namespace bempd::regions

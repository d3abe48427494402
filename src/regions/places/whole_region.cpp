#include "regions/places/whole_region.hpp"

#include <cmath>

#include "error.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

void WholeRegion::check(const scene::Scene& scene) const { scene.region(region_); }

std::vector<PlacedNode> WholeRegion::held_nodes(const scene::Scene&, const Discretization&, int support) const {
  fail(Failure::argument, "support ", support + 1, " holds all of region ", region_,
       "; supports hold edges and points: leave the region out instead");
}

void WholeRegion::add_load(const scene::Scene& scene, const Discretization& d, int load,
                           DofConditions& conditions) const {
  const scene::BoundaryValue value =
      scene.loads()[load].acting_value(bounding_box(scene.region(region_).outline()).center(), 0.0);
  for (int column = 0; column < 2; ++column) {
    const BodyForce body_force = force(column == 0 ? value.constant : value.proportional);
    require(body_force.uniform.allFinite() && std::isfinite(body_force.growth), "load ", load + 1, " on region ",
            region_, " is not a finite number");
    for (const int id : with_parts(scene, region_)) {
      d.region(id).loads().add_body_force(body_force, conditions.force.col(column));
      conditions.body_force.col(column).segment<3>(3 * (id - 1)) +=
          Eigen::Vector3d(body_force.uniform.x(), body_force.uniform.y(), body_force.growth);
    }
  }
}

}  // namespace bempd::regions

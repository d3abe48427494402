#include "regions/places/forced_nodes.hpp"

#include "error.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

void ForcedNodes::add_load(const scene::Scene& scene, const Discretization& d, int load,
                           DofConditions& conditions) const {
  require_free_edge(scene, d, load);
  for (const PlacedNode& n : nodes(scene, d)) {
    const scene::BoundaryValue value = scene.loads()[load].acting_value(d.positions[n.node], n.fraction);
    require(value.constant.allFinite() && value.proportional.allFinite(), "load ", load + 1,
            " is not a finite number at (", d.positions[n.node].x(), ", ", d.positions[n.node].y(), ")");
    conditions.force.col(0).segment<2>(2 * n.node) += value.constant;
    conditions.force.col(1).segment<2>(2 * n.node) += value.proportional;
  }
}

}  // namespace bempd::regions

#include "regions/interfaces.hpp"

#include <cmath>

#include "error.hpp"
#include "regions/scheme.hpp"

namespace bempd::regions {

using scene::NodeGrid;
using scene::Scene;

namespace {

// Throws Error (argument) for a curved edge whose chord lies on an edge of a lattice. An interface was intended there,
// but the arc leaves a gap or an overlap: interfaces with lattices must be straight.
void require_straight_interfaces(const Scene& scene, double tolerance) {
  const std::vector<int> ids = scene.region_ids();
  for (int id : ids) {
    for (const auto& [number, edge] : scene.region(id).outline().curved) {
      for (int other : ids) {
        if (!scene.region(other).node_grid()) continue;
        const Outline& lattice = scene.region(other).outline();
        const auto touches = [&](const Point& p) { return locate(lattice, p, tolerance) == Location::on_boundary; };
        const bool above = touches(edge.start) && touches(edge.end) && touches(Segment{edge.start, edge.end}.at(0.5));
        require(!above, "edge ", number + 1, " of region ", id,
                " is curved, and its chord lies on the boundary of the ", scene.region(other).adjective(), " region ",
                other, "; interfaces with ", scene.region(other).adjective(), " regions must be straight");
      }
    }
  }
}

void require_no_overlap(const Arrangement& arrangement) {
  if (const auto& overlap = arrangement.overlap) {
    require(false, "regions ", overlap->region_a + 1, " and ", overlap->region_b + 1, " overlap near (",
            overlap->where.x(), ", ", overlap->where.y(), "); regions may only share boundaries");
  }
  for (const PointTouch& hinge : arrangement.hinges) {
    require(false, "regions ", hinge.groups[0].front() + 1, " and ", hinge.groups[1].front() + 1, " touch only at (",
            hinge.where.x(), ", ", hinge.where.y(),
            "), which would be a hinge; let them share a piece of boundary or keep them apart");
  }
}

void require_one_grid(const Scene& scene, const Contact& contact) {
  const scene::Region& region = scene.region(contact.region + 1);
  const std::optional<NodeGrid> a = region.node_grid(), b = scene.region(contact.other_region + 1).node_grid();
  const Point offset = (b->origin - a->origin) / a->spacing;
  const Point rounded = offset.array().round();
  require(std::abs(b->spacing / a->spacing - 1) < 1e-9 && (offset - rounded).norm() < 1e-6, region.adjective(),
          " regions ", contact.region + 1, " and ", contact.other_region + 1,
          " touch, but their lattices do not match (spacings ", a->spacing, " and ", b->spacing,
          "); give them the same spacing and corners that are whole spacings apart");
}

}  // namespace

void require_compatible(const Preparation& p) {
  require_straight_interfaces(p.scene, p.tolerance);
  require_no_overlap(p.arrangement);
  for (const Contact& contact : p.arrangement.contacts) {
    if (!p.scene.region(contact.region + 1).node_grid() || !p.scene.region(contact.other_region + 1).node_grid())
      continue;
    p.scheme.require_grids_can_touch(contact.region + 1, contact.other_region + 1);
    require_one_grid(p.scene, contact);
  }
}

}  // namespace bempd::regions

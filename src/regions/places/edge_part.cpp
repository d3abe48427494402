#include "regions/places/edge_part.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "regions/boundary_conditions.hpp"
#include "regions/edge_nodes.hpp"

namespace bempd::regions {

void EdgePart::check(const scene::Scene& scene) const {
  const scene::Region& region = scene.region(region_);
  require(edge_ >= 1 && edge_ <= region.edge_count(), "edge ", edge_, " does not exist; region ", region_,
          " has edges 1 .. ", region.edge_count());
  require(std::isfinite(from_) && std::isfinite(to_) && from_ >= 0 && to_ <= 1 && to_ - from_ > 1e-9,
          "the part of the edge is from ", from_, " to ", to_, "; fractions must satisfy 0 <= from < to <= 1");
}

std::vector<double> EdgePart::breaks_on(const scene::Scene&, int region, int edge, double) const {
  if (region != region_ || edge != edge_) return {};
  return {from_, to_};
}

bool EdgePart::covers(int region, int edge, double fraction) const {
  return region == region_ && edge == edge_ && from_ <= fraction && fraction <= to_;
}

std::vector<PlacedNode> EdgePart::nodes(const scene::Scene& scene, const Discretization& d) const {
  return nodes_in_order(d, region_, {edge_, scene.region(region_).edge(edge_), from_, to_});
}

std::map<int, double> EdgePart::weights(const scene::Scene& scene, const Discretization& d) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(d.positions.size()));
  d.region(region_).loads().add_traction(
      {edge_, scene.region(region_).edge(edge_), from_, to_}, [](const Point&) { return Point(1, 0); }, force);
  std::map<int, double> found;
  for (const PlacedNode& n : nodes(scene, d)) found.emplace(n.node, force[2 * n.node]);
  return found;
}

std::vector<PlacedNode> EdgePart::held_nodes(const scene::Scene& scene, const Discretization& d, int support) const {
  std::vector<PlacedNode> nodes =
      d.region(region_).loads().nodes_on({edge_, scene.region(region_).edge(edge_), from_, to_}, d.tolerance);
  require(!nodes.empty(), "support ", support + 1, " holds no node: its part of edge ", edge_, " of region ", region_,
          " lies between two material points; widen it");
  return nodes;
}

void EdgePart::require_free_edge(const scene::Scene& scene, const Discretization& d, int load) const {
  const double edge_length = scene.region(region_).edge(edge_).length();
  for (const Contact& contact : d.arrangement.contacts) {
    if (contact.region != region_ - 1 || contact.edge != edge_ - 1) continue;
    const double shared = std::min(to_, contact.to) - std::max(from_, contact.from);
    require(shared * edge_length <= 10 * d.tolerance, "load ", load + 1, " puts a traction on edge ", edge_,
            " of region ", region_, ", which is an interface with region ", contact.other_region + 1, " from ",
            contact.from, " to ", contact.to, "; tractions act on free edges only");
  }
}

void EdgePart::add_load(const scene::Scene& scene, const Discretization& d, int load, DofConditions& conditions) const {
  const scene::Condition& condition = scene.loads()[load];
  const Edge edge = scene.region(region_).edge(edge_);
  require_free_edge(scene, d, load);
  for (int column = 0; column < 2; ++column) {
    const auto traction = [&](const Point& p) {
      const double fraction = closest_fraction(edge, p);
      const double along = std::clamp((fraction - from_) / (to_ - from_), 0.0, 1.0);
      const scene::BoundaryValue value = condition.acting_value(p, along);
      const Point& result = column == 0 ? value.constant : value.proportional;
      require(result.allFinite(), "load ", load + 1, " is not a finite number at (", p.x(), ", ", p.y(), ")");
      return this->traction(edge, fraction, result);
    };
    d.region(region_).loads().add_traction({edge_, edge, from_, to_}, traction, conditions.force.col(column));
  }
}

}  // namespace bempd::regions

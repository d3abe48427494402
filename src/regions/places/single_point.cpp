#include "regions/places/single_point.hpp"

#include <limits>

#include "error.hpp"
#include "regions/boundary_conditions.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

void SinglePoint::check(const scene::Scene& scene) const {
  require(where_.allFinite(), "the place is (", where_.x(), ", ", where_.y(), "); coordinates must be finite numbers");
  const Box body = scene.bounding_box();
  require(body.isEmpty() || body.exteriorDistance(where_) <= 10 * geometric_tolerance(body), "there is no node or ",
          "material point at (", where_.x(), ", ", where_.y(), "): the body reaches from (", body.min().x(), ", ",
          body.min().y(), ") to (", body.max().x(), ", ", body.max().y(), "); add its regions first");
}

std::vector<double> SinglePoint::breaks_on(const scene::Scene& scene, int region, int edge, double tolerance) const {
  const Edge whole = scene.region(region).edge(edge);
  if (distance(whole, where_) > tolerance) return {};
  return {closest_fraction(whole, where_)};
}

int SinglePoint::node_in(const Discretization& d) const {
  // Nodes on cuts between subdomains, which have no entry in fields, are not places that a host knows.
  std::vector<char> is_hidden(d.positions.size(), 0);
  for (const auto& region : d.regions) {
    const std::vector<int> entries = region->results().entries_of_nodes();
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (entries[i] < 0) is_hidden[static_cast<std::size_t>(region->nodes()[i])] = 1;
  }
  int nearest = -1;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < d.positions.size(); ++i) {
    const double distance = (d.positions[i] - where_).norm();
    if (distance < shortest && !is_hidden[i]) {
      shortest = distance;
      nearest = static_cast<int>(i);
    }
  }
  require(nearest >= 0 && shortest <= 10 * d.tolerance, "there is no node or material point at (", where_.x(), ", ",
          where_.y(), "); choose a place on a BEM boundary or a material point",
          nearest >= 0 ? text(", the nearest is (", d.positions[nearest].x(), ", ", d.positions[nearest].y(), ")")
                       : std::string());
  return nearest;
}

std::vector<PlacedNode> SinglePoint::held_nodes(const scene::Scene&, const Discretization& d, int) const {
  return {{node_in(d), 0.0}};
}

void SinglePoint::add_load(const scene::Scene& scene, const Discretization& d, int load,
                           DofConditions& conditions) const {
  const scene::Condition& condition = scene.loads()[load];
  const int node = node_in(d);
  const scene::BoundaryValue value = condition.value(where_, 0.0);
  for (int component = 0; component < 2; ++component) {
    if (!condition.acts_on(component)) continue;
    conditions.force(2 * node + component, 0) += value.constant[component];
    conditions.force(2 * node + component, 1) += value.proportional[component];
  }
}

}  // namespace bempd::regions

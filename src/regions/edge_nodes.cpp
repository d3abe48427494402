#include "regions/edge_nodes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "linalg/disjoint_sets.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

namespace {

bool has(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

// Map from some nodes of a region (numbers in the scene) to their entries in the region's fields; -1 for a node without
// an entry.
std::map<int, int> entries_of(const Region& region, const std::vector<PlacedNode>& placed) {
  std::map<int, int> of_node;
  for (const PlacedNode& n : placed) of_node.emplace(n.node, -1);
  const std::vector<int> entries = region.results().entries_of_nodes();
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (const auto wanted = of_node.find(region.nodes()[i]); wanted != of_node.end()) wanted->second = entries[i];
  return of_node;
}

}  // namespace

std::vector<PlacedNode> nodes_in_order(const Discretization& d, int region, const EdgeSpan& span) {
  std::vector<PlacedNode> nodes = d.region(region).loads().nodes_on(span, d.tolerance);
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const PlacedNode& one, const PlacedNode& other) { return one.fraction < other.fraction; });
  return nodes;
}

std::vector<EdgeNode> edge_nodes(const scene::Scene& scene, const Discretization& d, int region_id, int edge) {
  const Region& region = d.region(region_id);
  const EdgeSpan span{edge, scene.region(region_id).edge(edge), 0, 1};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(d.positions.size()));
  region.loads().add_traction(
      span, [](const Point&) { return Point(1, 0); }, force);
  const std::vector<PlacedNode> placed = nodes_in_order(d, region_id, span);
  const std::map<int, int> entries = entries_of(region, placed);
  std::vector<EdgeNode> all;
  all.reserve(placed.size());
  for (const PlacedNode& n : placed)
    all.push_back({n.node, entries.at(n.node), n.fraction, force[2 * n.node] / region.elasticity().thickness});
  return all;
}

std::vector<int> edge_cells(const Discretization& d, int region, const std::vector<EdgeNode>& nodes) {
  std::map<std::pair<int, int>, std::size_t> sides;  // by the entries of the nodes at their ends, in both orders
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    sides.emplace(std::make_pair(nodes[i].entry, nodes[i + 1].entry), i);
    sides.emplace(std::make_pair(nodes[i + 1].entry, nodes[i].entry), i);
  }
  const Cells cells = d.region(region).results().cells();
  const auto corners = static_cast<std::size_t>(cells.nodes_per_cell);
  std::map<std::size_t, int> at_side;
  for (std::size_t cell = 0; cell < cells.nodes.size() / corners; ++cell) {
    for (std::size_t k = 0; k < corners; ++k) {
      const auto corner = [&](std::size_t number) { return cells.nodes[cell * corners + number % corners]; };
      const auto side = sides.find({corner(k), corner(k + 1)});
      if (side != sides.end()) at_side.emplace(side->second, static_cast<int>(cell));
    }
  }
  std::vector<int> found;
  for (const auto& [side, cell] : at_side)
    if (found.empty() || found.back() != cell) found.push_back(cell);
  return found;
}

std::vector<int> regions_of_body(const Discretization& d, int region) {
  const int count = static_cast<int>(d.regions.size());
  const auto has_bonds = [](const auto& r) { return r->bonds() != nullptr; };
  if (!d.region(region).bonds() || std::count_if(d.regions.begin(), d.regions.end(), has_bonds) == 1) return {region};
  linalg::DisjointSets bodies(count);
  std::vector<int> first_with;  // by term: index of the first region that has it
  for (int r = 0; r < count; ++r) {
    const RegionBonds* bonds = d.regions[static_cast<std::size_t>(r)]->bonds();
    if (!bonds) continue;
    for (const int term : bonds->terms()) {
      const auto place = static_cast<std::size_t>(term);
      if (first_with.size() <= place) first_with.resize(std::max(place + 1, 2 * first_with.size()), -1);
      if (first_with[place] < 0) first_with[place] = r;
      bodies.join(first_with[place], r);
    }
  }
  const auto wanted =
      std::find_if(d.regions.begin(), d.regions.end(), [&](const auto& r) { return r->id() == region; });
  const int body = bodies.find(static_cast<int>(wanted - d.regions.begin()));
  std::vector<int> ids;
  for (int r = 0; r < count; ++r)
    if (bodies.find(r) == body) ids.push_back(d.regions[static_cast<std::size_t>(r)]->id());
  return ids;
}

coupling::Affine loads_on(const scene::Scene& scene, const Discretization& d, const std::vector<int>& regions) {
  const auto acts = [&](const scene::Place& place) {
    if (place.is_built_in()) return false;
    if (std::any_of(regions.begin(), regions.end(), [&](int id) { return place.needs(id); })) return true;
    for (std::size_t crack = 0; crack < d.cracks.size(); ++crack) {
      const auto is_on = [&](int id) { return d.cracks[crack].has_elements_in(id); };
      if (place.needs_crack(static_cast<int>(crack) + 1) && std::any_of(regions.begin(), regions.end(), is_on))
        return true;
    }
    return false;
  };
  DofConditions c;
  c.force = coupling::Affine::Zero(2 * static_cast<Eigen::Index>(d.positions.size()), 2);
  c.body_force = coupling::Affine::Zero(3 * scene.region_count(), 2);
  for (std::size_t l = 0; l < scene.loads().size(); ++l) {
    const scene::Condition& load = scene.loads()[l];
    if (!load.removed() && acts(*load.place)) load.place->add_load(scene, d, static_cast<int>(l), c);
  }
  return c.force;
}

bool has_interface(const Discretization& d, int region, int edge) {
  return std::any_of(d.arrangement.contacts.begin(), d.arrangement.contacts.end(),
                     [&](const Contact& contact) { return contact.region == region - 1 && contact.edge == edge - 1; });
}

std::vector<int> interface_nodes(const scene::Scene& scene, const Discretization& d, const std::vector<int>& body,
                                 int region, int edge) {
  std::set<int> nodes;
  for (const Contact& contact : d.arrangement.contacts) {
    if (contact.region != region - 1 || contact.edge != edge - 1 || has(body, contact.other_region + 1)) continue;
    const EdgeSpan span{edge, scene.region(region).edge(edge), contact.from, contact.to};
    for (const PlacedNode& n : d.region(region).loads().nodes_on(span, d.tolerance)) nodes.insert(n.node);
  }
  return {nodes.begin(), nodes.end()};
}

}  // namespace bempd::regions

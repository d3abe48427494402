#include <algorithm>
#include <map>
#include <set>

#include "error.hpp"
#include "model/edge_results.hpp"
#include "model/model.hpp"
#include "regions/places/edge_part.hpp"

namespace bempd::model {

namespace {

using EdgeWithNumber = std::pair<int, int>;  // id of the region, number

std::vector<char> nodes_of_bonded_regions_before(const regions::Discretization& d, const std::vector<int>& body) {
  std::vector<char> found(d.positions.size(), 0);
  for (const auto& region : d.regions) {
    if (region->id() >= body.front()) break;
    if (!region->bonds()) continue;
    for (const int node : region->nodes()) found[static_cast<std::size_t>(node)] = 1;
  }
  return found;
}

}  // namespace

std::vector<regions::EdgeNode> EdgeResults::nodes(int region, int edge) {
  model_.scene().region_with_edge(region, edge);
  return regions::edge_nodes(model_.scene(), model_.prepared().discretization, region, edge);
}

std::vector<int> EdgeResults::cells(int region, int edge) {
  return regions::edge_cells(model_.prepared().discretization, region, nodes(region, edge));
}

// Forces of neighbours and supports on a body (ids of its regions), at all nodes: the forces that deform the body's
// elements and bonds, minus the loads on the body.
Eigen::VectorXd EdgeResults::forces_from_outside(const std::vector<int>& body) {
  const PreparedScene& prepared = model_.prepared();
  const regions::Discretization& d = prepared.discretization;
  const fracture::EvolutionState& state = prepared.evolution->state();
  const coupling::EquilibriumSystem& system = *prepared.system;
  std::vector<int> terms;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(state.total_displacement.size());
  for (const int id : body) {
    if (const regions::RegionBonds* bonds = d.region(id).bonds()) {
      const std::vector<int> own = bonds->terms();
      terms.insert(terms.end(), own.begin(), own.end());
    }
    const regions::RegionOperators* operators = d.region(id).operators();
    if (!operators) continue;
    for (const regions::OperatorNodes& one : operators->nodes_of_operators())
      force += system.operators().force_on(one.nodes, state.total_displacement, state.load_factor);
  }
  if (body.size() > 1) {  // regions of a body share bonds
    std::sort(terms.begin(), terms.end());
    terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  }
  force += system.response().force_of_terms(terms, state.total_displacement, state.load_factor);
  coupling::Affine loads = model_.loads().loads_in_force_on(body);
  // Loads are corrected for two things: fragments lose their loads, and the fluid pressure in broken bonds is a load
  // that the conditions do not contain.
  coupling::Affine given = prepared.conditions.force;
  system.ties().collect(given);
  const coupling::Affine beside = system.load().force() - given;
  const std::vector<char> others = nodes_of_bonded_regions_before(d, body);
  const bool has_fluid = d.region(body.front()).bonds() && !prepared.conditions.crack_pressures.empty();
  for (Eigen::Index node = 0; 2 * node < loads.rows(); ++node) {
    const auto place = static_cast<std::size_t>(node);
    if (state.unloaded[place]) {
      loads.middleRows<2>(2 * node).setZero();
    } else if (has_fluid && !others[place]) {
      loads.middleRows<2>(2 * node) += beside.middleRows<2>(2 * node);
    }
  }
  return force - coupling::evaluate(loads, state.load_factor);
}

// Forces of neighbouring regions at the nodes of an interface. Where several interfaces of a body meet in a node, each
// interface gets the force of the tractions along it, and an equal share of the rest of the node's force.
std::map<int, Point> EdgeResults::forces_of_neighbours(int region_id, int edge) {
  const regions::Discretization& d = model_.prepared().discretization;
  const scene::Scene& scene = model_.scene();
  if (!regions::has_interface(d, region_id, edge)) return {};
  const std::vector<int> body = regions::regions_of_body(d, region_id);
  const std::vector<int> wanted = regions::interface_nodes(scene, d, body, region_id, edge);
  if (wanted.empty()) return {};
  require(!d.region(region_id).bonds() || model_.options().text_value("scheme") != "paper", "edge ", edge,
          " of region ", region_id,
          " is an interface, and in scheme paper the points along it are none of its nodes; ask for the edge "
          "of the boundary element region there");
  Eigen::VectorXd force = forces_from_outside(body);
  std::set<EdgeWithNumber> held;
  for (const scene::Condition& support : scene.supports()) {
    const auto name = support.removed() ? std::nullopt : support.place->edge();
    if (name && std::find(body.begin(), body.end(), name->first) != body.end()) held.insert(*name);
  }
  for (const EdgeWithNumber& name : held)
    for (const auto& [dof, part] : forces_of_supports(name.first, name.second)) force[dof] -= part;
  std::map<int, std::vector<EdgeWithNumber>> edges_at;
  for (const int id : body)
    for (int k = 1; k <= scene.region(id).edge_count(); ++k)
      for (const int node : regions::interface_nodes(scene, d, body, id, k)) edges_at[node].emplace_back(id, k);
  std::map<int, Point> parts;
  for (const int node : wanted) {
    const std::vector<EdgeWithNumber>& edges = edges_at[node];
    Point own = Point::Zero(), rest = force.segment<2>(2 * node);
    if (edges.size() > 1) {
      for (const EdgeWithNumber& name : edges) {
        const Point there = traction_forces(name.first, name.second, {node}).front();
        if (name == EdgeWithNumber(region_id, edge)) own = there;
        rest -= there;
      }
    }
    parts.emplace(node, own + rest / static_cast<double>(edges.size()));
  }
  return parts;
}

std::vector<Point> EdgeResults::forces(int region, int edge) {
  model_.scene().region_with_edge(region, edge);
  model_.in_equilibrium();
  const std::map<int, double> of_supports = forces_of_supports(region, edge);
  const std::map<int, Point> of_neighbours = forces_of_neighbours(region, edge);
  require(!of_supports.empty() || !of_neighbours.empty(), "edge ", edge, " of region ", region,
          " is neither held by a support nor an interface with another region without bonds across it; ask for the "
          "forces of such an edge");
  std::vector<Point> forces;
  for (const regions::EdgeNode& n : nodes(region, edge)) {
    Point force = Point::Zero();
    for (int component = 0; component < 2; ++component) {
      const auto part = of_supports.find(2 * n.node + component);
      if (part != of_supports.end()) force[component] = part->second;
    }
    if (const auto part = of_neighbours.find(n.node); part != of_neighbours.end()) force += part->second;
    if (!force.allFinite())
      fail(Failure::unsolvable, "a result is beyond the range of numbers; choose other units or smaller loads");
    forces.push_back(force);
  }
  return forces;
}

}  // namespace bempd::model

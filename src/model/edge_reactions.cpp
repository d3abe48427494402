#include <algorithm>
#include <cmath>
#include <map>

#include "error.hpp"
#include "model/edge_results.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

using regions::Field;
using regions::FieldValues;
using EdgeName = std::pair<int, int>;  // id of the region, number

// Edges whose supports hold a degree of freedom; by degree of freedom.
using Holders = std::map<int, std::vector<EdgeName>>;

Holders holders_of(const scene::Scene& scene, const regions::DofConditions& conditions, const EdgeName& wanted) {
  Holders holders;
  for (const bool first : {true, false}) {
    for (std::size_t s = 0; s < scene.supports().size(); ++s) {
      const scene::Condition& support = scene.supports()[s];
      const auto edge = support.removed() ? std::nullopt : support.place->edge();
      if (!edge || (*edge == wanted) != first) continue;
      for (const int dof : conditions.held_dofs[s]) {
        const auto of_dof = first ? holders.try_emplace(dof).first : holders.find(dof);
        if (of_dof == holders.end()) continue;
        std::vector<EdgeName>& all = of_dof->second;
        if (std::find(all.begin(), all.end(), *edge) == all.end()) all.push_back(*edge);
      }
    }
  }
  return holders;
}

}  // namespace

std::vector<Point> EdgeResults::traction_forces(int id, int edge, const std::vector<int>& nodes) {
  Results& results = model_.results();
  const auto fields = [&results, id](Field which) -> const FieldValues& { return results.field(id, which); };
  return results.region(id).loads().forces_on_edge({edge, model_.scene().region(id).edge(edge), 0, 1}, nodes, fields);
}

std::map<int, double> EdgeResults::forces_of_supports(int region_id, int edge) {
  const EdgeName wanted(region_id, edge);
  const PreparedScene& prepared = model_.prepared();
  const Holders holders = holders_of(model_.scene(), prepared.conditions, wanted);
  // Nodal forces of the tractions along each held edge, at nodes that several held edges share. They divide the
  // reaction at such a node among the edges.
  std::map<EdgeName, std::map<int, Point>> tractions;
  for (const auto& [dof, edges] : holders)
    if (edges.size() > 1)
      for (const EdgeName& name : edges) tractions[name].emplace(dof / 2, Point::Zero());
  for (auto& [name, at_nodes] : tractions) {
    std::vector<int> nodes;
    for (const auto& [node, force] : at_nodes) nodes.push_back(node);
    const std::vector<Point> forces = traction_forces(name.first, name.second, nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) at_nodes[nodes[i]] = forces[i];
  }
  std::map<int, double> parts;
  for (const auto& [dof, edges] : holders) {
    const int node = dof / 2, component = dof % 2;
    double force = prepared.evolution->body().supports().reaction_at(dof);
    if (edges.size() > 1) {
      double rest = force;
      for (const EdgeName& name : edges) rest -= tractions[name][node][component];
      force = tractions[wanted][node][component] + rest / static_cast<double>(edges.size());
    }
    parts.emplace(dof, force);
  }
  return parts;
}

EdgeResults::Reaction EdgeResults::reaction(int region_id, int edge, const Point& about) {
  model_.scene().region_with_edge(region_id, edge);
  const PreparedScene& prepared = model_.in_equilibrium();
  const std::map<int, double> parts = forces_of_supports(region_id, edge);
  require(!parts.empty(), "no support holds edge ", edge, " of region ", region_id,
          "; reactions act on edges that are held");
  Reaction sum{Eigen::Vector2d::Zero(), 0};
  for (const auto& [dof, force] : parts) {
    const int component = dof % 2;
    const Point arm = prepared.discretization.positions[static_cast<std::size_t>(dof / 2)] - about;
    sum.force[component] += force;
    sum.moment += force * (component == 0 ? -arm.y() : arm.x());
  }
  if (!sum.force.allFinite() || !std::isfinite(sum.moment))
    fail(Failure::unsolvable, "a result is beyond the range of numbers; choose other units or smaller loads");
  return sum;
}

}  // namespace bempd::model

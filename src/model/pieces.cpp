#include "model/pieces.hpp"

#include <algorithm>

#include "crack/cannot_grow.hpp"
#include "error.hpp"
#include "fracture/connectivity.hpp"
#include "model/model.hpp"

namespace bempd::model {

std::vector<coupling::HeldDirection> held_directions(const PreparedScene& p, const std::vector<int>& nodes) {
  std::vector<coupling::HeldDirection> held;
  for (int node : nodes) {
    if (p.conditions.prescribed[2 * node]) held.push_back({node, 1, 0});
    if (p.conditions.prescribed[2 * node + 1]) held.push_back({node, 0, 1});
  }
  return held;
}

const PieceNodes& Pieces::all() {
  const PreparedScene& prepared = model_.prepared();
  if (generation_ == model_.generation()) return found_;
  prepared.evolution->sources().refresh();
  PieceNodes found;
  found.nodes = fracture::Connectivity(*prepared.system).pieces();
  std::stable_sort(found.nodes.begin(), found.nodes.end(),
                   [](const auto& one, const auto& other) { return one.size() > other.size(); });
  found.of_node.resize(prepared.discretization.positions.size());
  for (std::size_t k = 0; k < found.nodes.size(); ++k)
    for (int node : found.nodes[k]) found.of_node[static_cast<std::size_t>(node)] = static_cast<int>(k) + 1;
  found_ = std::move(found);
  generation_ = model_.generation();
  return found_;
}

void check_loads_inside_free_pieces(const PreparedScene& p) {
  const auto is_loaded_inside = [&](const regions::Region& region) {
    const regions::CrackElements* cracks = region.crack_elements();
    if (!cracks || !cracks->cut_the_region()) return false;
    const auto of_crack = [&](const regions::CrackLoad& load) { return cracks->lie_inside(load.crack); };
    const std::vector<regions::CrackLoad>& loads = p.conditions.crack_loads;
    return !p.conditions.body_force.middleRows<3>(3 * static_cast<Eigen::Index>(region.id() - 1)).isZero(0) ||
           std::any_of(loads.begin(), loads.end(), of_crack);
  };
  const auto& regions = p.discretization.regions;
  if (std::none_of(regions.begin(), regions.end(), [&](const auto& region) { return is_loaded_inside(*region); }))
    return;
  for (const std::vector<int>& nodes : fracture::Connectivity(*p.system).pieces()) {
    const coupling::RigidMotion motion(p.discretization.positions, nodes, held_directions(p, nodes));
    const auto has_node_of = [&](const regions::Region& region) {
      return std::any_of(region.nodes().begin(), region.nodes().end(),
                         [&](int node) { return std::binary_search(nodes.begin(), nodes.end(), node); });
    };
    if (!fracture::is_pushed(motion, p.discretization.positions, nodes, p.conditions.force)) continue;
    for (const auto& region : regions) {
      if (!is_loaded_inside(*region) || !has_node_of(*region)) continue;
      throw crack::FreesLoadedPart(text("cracks free a piece of region ", region->id(),
                                        " that a force per volume or a load on a crack pushes away; add supports that "
                                        "hold it, or take that load off"));
    }
  }
}

int Pieces::anchored_count() {
  const PieceNodes& all = this->all();
  const regions::DofConditions& c = model_.prepared().conditions;
  std::vector<char> anchored(all.nodes.size() + 1, 0);
  for (std::size_t dof = 0; dof < c.prescribed.size(); ++dof) {
    const bool loaded = !c.force.row(static_cast<Eigen::Index>(dof)).isZero(0);
    if (c.prescribed[dof] || loaded) anchored[static_cast<std::size_t>(all.of_node[dof / 2])] = 1;
  }
  return static_cast<int>(std::count(anchored.begin(), anchored.end(), 1));
}

std::vector<int> Pieces::numbers_of(std::vector<int> nodes) {
  const PieceNodes& all = this->all();
  for (int& node : nodes) node = all.of_node[static_cast<std::size_t>(node)];
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> Pieces::of_support(int support) {
  model_.scene().support(support);  // throws without it
  std::vector<int> nodes;
  for (int dof : model_.prepared().conditions.held_dofs[static_cast<std::size_t>(support) - 1])
    nodes.push_back(dof / 2);
  return numbers_of(std::move(nodes));
}

// Nodes on which a load (id) exerts forces when its values are 1.
std::vector<int> Pieces::loaded_nodes(int load) {
  const std::size_t place = static_cast<std::size_t>(load) - 1;
  scene::SceneValues values = scene::at_rest(model_.scene().values());
  if (auto* samples = std::get_if<scene::SampledValues>(&values.loads[place])) {
    std::fill(samples->constant.begin(), samples->constant.end(), 1.0);
  } else {
    values.loads[place] = scene::BoundaryFunction([](const Point&, double) -> scene::BoundaryValue {
      return {Point::Ones(), Point::Zero()};
    });
  }
  const Eigen::VectorXd force = model_.loads().conditions_under(std::move(values)).force.col(0);
  std::vector<int> nodes;
  for (Eigen::Index dof = 0; dof < force.size(); ++dof)
    if (force[dof] != 0) nodes.push_back(static_cast<int>(dof / 2));
  return nodes;
}

std::vector<int> Pieces::of_load(int load) {
  model_.scene().load(load);  // throws without it
  model_.prepare();
  return numbers_of(loaded_nodes(load));
}

std::vector<int> Pieces::of_nodes_in(int region) {
  const std::vector<int> nodes = model_.results().region(region).results().nodes_of_entries();
  const PieceNodes& all = this->all();
  std::vector<int> numbers;
  numbers.reserve(nodes.size());
  for (int node : nodes) numbers.push_back(all.of_node[static_cast<std::size_t>(node)]);
  return numbers;
}

PieceState Pieces::state(int number) {
  const auto count = static_cast<int>(all().nodes.size());
  require(number >= 1 && number <= count, "piece ", number, " does not exist; there are ", count);
  const PreparedScene& prepared = model_.in_equilibrium();
  const scene::Scene& scene = model_.scene();
  const std::vector<int>& nodes = all().nodes[static_cast<std::size_t>(number) - 1];
  PieceState state;
  state.nodes = static_cast<std::int64_t>(nodes.size());
  const auto has = [&](const std::vector<int>& all) { return std::binary_search(all.begin(), all.end(), number); };
  for (std::size_t s = 0; s < scene.supports().size(); ++s)
    if (!scene.supports()[s].removed() && has(of_support(static_cast<int>(s) + 1))) ++state.supports;
  for (std::size_t l = 0; l < scene.loads().size(); ++l)
    if (!scene.loads()[l].removed() && has(of_load(static_cast<int>(l) + 1))) ++state.loads;
  const std::vector<coupling::HeldDirection> held = held_directions(prepared, nodes);
  const std::vector<Point>& positions = prepared.discretization.positions;
  state.free_motions = coupling::RigidMotion(positions, nodes, held).free_count();
  state.motion = coupling::nearest_rigid_motion(positions, nodes, prepared.evolution->state().total_displacement);
  return state;
}

}  // namespace bempd::model

#include <algorithm>

#include "error.hpp"
#include "fracture/connectivity.hpp"
#include "model/held_directions.hpp"
#include "model/model.hpp"

// Pieces that bonds and boundary elements still join.
namespace bempd::model {

std::vector<coupling::HeldDirection> held_directions(const PreparedScene& p, const std::vector<int>& nodes) {
  std::vector<coupling::HeldDirection> held;
  for (int node : nodes) {
    if (p.conditions.prescribed[2 * node]) held.push_back({node, 1, 0});
    if (p.conditions.prescribed[2 * node + 1]) held.push_back({node, 0, 1});
  }
  return held;
}

const Pieces& Model::pieces() {
  prepare();
  if (pieces_generation_ == generation_) return pieces_;
  prepared_->evolution->bring_terms_up_to_date();
  Pieces found;
  found.nodes = fracture::Connectivity(*prepared_->system).pieces();
  std::stable_sort(found.nodes.begin(), found.nodes.end(),
                   [](const auto& one, const auto& other) { return one.size() > other.size(); });
  found.of_node.resize(prepared_->discretization.positions.size());
  for (std::size_t k = 0; k < found.nodes.size(); ++k)
    for (int node : found.nodes[k]) found.of_node[static_cast<std::size_t>(node)] = static_cast<int>(k) + 1;
  pieces_ = std::move(found);
  pieces_generation_ = generation_;
  return pieces_;
}

// Refuses free pieces with loads inside: boundary elements have loads on the inside of a region as a whole, so that a
// piece that growing cracks free cannot lose its part of them.
void Model::check_loads_inside_free_pieces(const PreparedScene& p) const {
  const auto is_loaded_inside = [&](const regions::Region& region) {
    if (!region.is_cut()) return false;
    const auto of_crack = [&](const regions::CrackLoad& load) { return region.has_inner_crack(load.crack); };
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
      fail(Failure::unsolvable, "cracks free a piece of region ", region->id(),
           " that a force per volume or a load on a crack pushes away; add supports that hold it, or take that load "
           "off");
    }
  }
}

// Number of pieces that supports hold or loads act on.
int Model::anchored_pieces() {
  const regions::DofConditions& c = prepared_->conditions;
  const Pieces& all = pieces();
  std::vector<char> anchored(all.nodes.size() + 1, 0);
  for (std::size_t dof = 0; dof < c.prescribed.size(); ++dof) {
    const bool loaded = !c.force.row(static_cast<Eigen::Index>(dof)).isZero(0);
    if (c.prescribed[dof] || loaded) anchored[static_cast<std::size_t>(all.of_node[dof / 2])] = 1;
  }
  return static_cast<int>(std::count(anchored.begin(), anchored.end(), 1));
}

bool Model::hangs() {
  return prepared_->evolution->progress().separated && anchored_pieces() <= prepared_->anchored_pieces;
}

std::vector<int> Model::pieces_of(std::vector<int> nodes) {
  const Pieces& all = pieces();
  for (int& node : nodes) node = all.of_node[static_cast<std::size_t>(node)];
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> Model::pieces_of_support(int support) {
  scene_.support(support);
  prepare();
  std::vector<int> nodes;
  for (int dof : prepared_->conditions.held_dofs[static_cast<std::size_t>(support) - 1]) nodes.push_back(dof / 2);
  return pieces_of(std::move(nodes));
}

// Nodes on which the load has forces if its values are 1.
std::vector<int> Model::loaded_nodes(int load) {
  const std::size_t place = static_cast<std::size_t>(load) - 1;
  scene::SceneValues values = scene::at_rest(scene_.values());
  if (auto* samples = std::get_if<scene::SampledValues>(&values.loads[place])) {
    std::fill(samples->constant.begin(), samples->constant.end(), 1.0);
  } else {
    values.loads[place] = scene::BoundaryFunction([](const Point&, double) -> scene::BoundaryValue {
      return {Point::Ones(), Point::Zero()};
    });
  }
  const Eigen::VectorXd force = conditions_under(std::move(values)).force.col(0);
  std::vector<int> nodes;
  for (Eigen::Index dof = 0; dof < force.size(); ++dof)
    if (force[dof] != 0) nodes.push_back(static_cast<int>(dof / 2));
  return nodes;
}

std::vector<int> Model::pieces_of_load(int load) {
  scene_.load(load);
  prepare();
  return pieces_of(loaded_nodes(load));
}

std::vector<int> Model::node_pieces(int id) {
  const std::vector<int> nodes = region(id).nodes_of_entries();
  const Pieces& all = pieces();
  std::vector<int> result;
  result.reserve(nodes.size());
  for (int node : nodes) result.push_back(all.of_node[static_cast<std::size_t>(node)]);
  return result;
}

PieceState Model::piece(int number) {
  const auto count = static_cast<int>(pieces().nodes.size());
  require(number >= 1 && number <= count, "piece ", number, " does not exist; there are ", count);
  ensure_equilibrium();
  const std::vector<int>& nodes = pieces().nodes[static_cast<std::size_t>(number) - 1];
  PieceState state;
  state.nodes = static_cast<std::int64_t>(nodes.size());
  const auto has = [&](const std::vector<int>& all) { return std::binary_search(all.begin(), all.end(), number); };
  for (std::size_t s = 0; s < scene_.supports().size(); ++s)
    if (!scene_.supports()[s].removed() && has(pieces_of_support(static_cast<int>(s) + 1))) ++state.supports;
  for (std::size_t l = 0; l < scene_.loads().size(); ++l)
    if (!scene_.loads()[l].removed() && has(pieces_of_load(static_cast<int>(l) + 1))) ++state.loads;
  const std::vector<coupling::HeldDirection> held = held_directions(*prepared_, nodes);
  const std::vector<Point>& positions = prepared_->discretization.positions;
  state.free_motions = coupling::RigidMotion(positions, nodes, held).free_count();
  state.motion = coupling::nearest_rigid_motion(positions, nodes, prepared_->evolution->state().total_displacement);
  return state;
}

}  // namespace bempd::model

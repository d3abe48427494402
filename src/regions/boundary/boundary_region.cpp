#include "regions/boundary/boundary_region.hpp"

#include <algorithm>
#include <typeinfo>

#include "bem/boundary_loads.hpp"
#include "bem/galerkin_operator.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/crack_crossings.hpp"

namespace bempd::regions {

// Roles of the mesh's nodes: `shared` nodes may be nodes of other regions too. A `slaved` node's displacement follows
// from its masters': a mid node of an element on a grid has the mean of the element's ends.
struct BoundaryRegion::NodeRoles {
  std::vector<char> shared, slaved;
  std::vector<std::vector<std::pair<int, double>>> masters;  // with weights; they may be slaved themselves

  void add(int node, double weight, std::vector<std::pair<int, double>>& to) const {
    if (!slaved[static_cast<std::size_t>(node)]) return to.emplace_back(node, weight), void();
    for (const auto& [master, share] : masters[static_cast<std::size_t>(node)]) add(master, weight * share, to);
  }
};

BoundaryRegion::BoundaryRegion(int id, const BoundaryDescription&, const scene::Material& material)
    : Region(id, material) {}

BoundaryRegion::~BoundaryRegion() = default;

MeshingRules BoundaryRegion::meshing_rules(const Preparation& preparation) const {
  return {false, preparation.options.text_value("bem.grading") == "auto"};
}

std::shared_ptr<const bem::BoundaryOperator> BoundaryRegion::make_operator(const Preparation&,
                                                                           const bem::AssemblyOptions& assembly) const {
  return std::make_shared<const bem::GalerkinOperator>(mesh_, elasticity(), assembly);
}

void BoundaryRegion::mesh(const Preparation& preparation) {
  const MeshingRules rules = meshing_rules(preparation);
  middles_follow_ends_ = !rules.nodes_on_grids;
  cracks_ = cracks_of(preparation, id());
  BoundaryPanels panels = mesh_edges(preparation, rules, id(), cracks_ ? cracks_->mouths() : std::vector<Point>());
  refine_at_cracks(preparation, cracks_.get(), panels);
  halve_elements(preparation, id(), panels);
  panels_ = std::move(panels.sources);
  mesh_ = make_mesh(panels.loops);
  cut_if_large(preparation);
  if (cracks_) mesh_cracks(preparation);
}

BoundaryRegion::NodeRoles BoundaryRegion::roles() const {
  const std::size_t count = mesh_.nodes.size();
  NodeRoles roles{std::vector<char>(count, 0), std::vector<char>(count, 0),
                  std::vector<std::vector<std::pair<int, double>>>(count)};
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    const BoundaryElement& element = mesh_.elements[e];
    const PanelSource& panel = panels_[element.panel];
    if (panel.border == Border::free) continue;
    if (panel.tied) {
      // Nodes at the two ends of a tied interface are shared by both regions, all others are not.
      if (e == 0 || mesh_.elements[e - 1].panel != element.panel) roles.shared[element.nodes[0]] = 1;
      const bool is_last = e + 1 == mesh_.elements.size() || mesh_.elements[e + 1].panel != element.panel;
      if (is_last) roles.shared[element.nodes[2]] = 1;
      continue;
    }
    for (int node : element.nodes) roles.shared[node] = 1;
    if (panel.border == Border::grid && middles_follow_ends_) {
      roles.slaved[element.nodes[1]] = 1;
      roles.masters[element.nodes[1]] = {{element.nodes[0], 0.5}, {element.nodes[2], 0.5}};
    }
  }
  if (cracks_) follow_rows_to_mouths(roles);
  return roles;
}

// Sets the displacements at mouths of cracks that continue in a lattice. A mouth lies between two material points. Each
// face there follows the straight line through the two nearest points on its side, or is free if there is one point
// only.
void BoundaryRegion::follow_rows_to_mouths(NodeRoles& roles) const {
  const auto lead_to = [&](int mouth, std::size_t element, int step) {
    const BoundaryElement& own = mesh_.elements[element];
    const PanelSource& panel = panels_[own.panel];
    if (panel.border != Border::grid) return;
    roles.shared[mouth] = 0;
    const std::size_t next = element + static_cast<std::size_t>(step);
    if (panel.tied || next >= mesh_.elements.size() || mesh_.elements[next].panel != own.panel) return;
    const int near = own.nodes[step < 0 ? 0 : 2], far = mesh_.elements[next].nodes[step < 0 ? 0 : 2];
    if (!roles.shared[far]) return;
    const double beyond = (mesh_.nodes[mouth] - mesh_.nodes[near]).norm();
    const double share = beyond / (mesh_.nodes[near] - mesh_.nodes[far]).norm();
    roles.slaved[mouth] = 1;
    roles.masters[mouth] = {{near, 1 + share}, {far, -share}};
  };
  if (subdomains_) return;  // cracks in subdomains do not continue in a lattice
  for (const auto& [before, behind] : cracked_.front().elements().mouth_of_joint) {
    if (before < 0) continue;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (mesh_.elements[e].nodes[2] == before) lead_to(before, e, -1);
      if (mesh_.elements[e].nodes[0] == behind) lead_to(behind, e, 1);
    }
  }
}

// Side of the crack on which each node of the mesh lies at mouths that are shared with another boundary element region:
// 1 left, -1 right, 0 elsewhere.
std::vector<int> BoundaryRegion::sides_of_cracks(const Preparation& p) const {
  std::vector<int> sides(mesh_.nodes.size(), 0);
  for (const SharedMouth& mouth : shared_mouths(p.cracks)) {
    for (const BoundaryElement& element : mesh_.elements) {
      if (panels_[element.panel].edge == 0) continue;  // on the crack itself
      for (const int node : {element.nodes[0], element.nodes[2]})
        if ((mesh_.nodes[node] - mouth.place).norm() <= 16 * p.tolerance)
          sides[node] = mouth.side_of(mesh_.nodes[element.nodes[1]]);
    }
  }
  return sides;
}

void BoundaryRegion::number_nodes(const Preparation& preparation, NodeRegistry& registry) {
  const std::size_t count = mesh_.nodes.size();
  const NodeRoles roles = this->roles();
  const std::vector<int> sides = sides_of_cracks(preparation);
  node_of_mesh_node_.assign(count, -1);
  std::vector<int> column(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (roles.slaved[i]) continue;
    column[i] = static_cast<int>(nodes_.size());
    nodes_.push_back(roles.shared[i] ? registry.add_shared(mesh_.nodes[i], id(), sides[i])
                                     : registry.add(mesh_.nodes[i]));
    node_of_mesh_node_[i] = nodes_.back();
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < count; ++i) {
    const int row = 2 * static_cast<int>(i);
    for (int component = 0; component < 2; ++component) {
      if (!roles.slaved[i]) {
        entries.emplace_back(row + component, 2 * column[i] + component, 1.0);
        continue;
      }
      std::vector<std::pair<int, double>> masters;
      roles.add(static_cast<int>(i), 1, masters);
      for (const auto& [master, weight] : masters)
        entries.emplace_back(row + component, 2 * column[master] + component, weight);
    }
  }
  for (std::size_t i = count; i < places().size(); ++i) {
    for (const int component : {0, 1})
      entries.emplace_back(2 * static_cast<int>(i) + component, 2 * static_cast<int>(nodes_.size()) + component, 1.0);
    nodes_.push_back(registry.add(places()[i]));
  }
  trace_.resize(2 * static_cast<Eigen::Index>(places().size()), 2 * static_cast<Eigen::Index>(nodes_.size()));
  trace_.setFromTriplets(entries.begin(), entries.end());
}

// Earlier regions of the same kind and material. One of them lends its operators, or those of its subdomains without
// cracks, if its mesh differs by a translation only. Operators with cracks are not lent.
std::vector<const BoundaryRegion*> BoundaryRegion::regions_alike(const Preparation& preparation) const {
  std::vector<const BoundaryRegion*> found;
  for (const auto& other : preparation.regions) {
    if (other.get() == this || (cracks_ && !subdomains_)) break;
    const Region& before = *other;
    if (typeid(before) != typeid(*this) || elasticity() != before.elasticity()) continue;
    const auto& alike = static_cast<const BoundaryRegion&>(before);
    if (!alike.cracks_ || alike.subdomains_) found.push_back(&alike);
  }
  return found;
}

void BoundaryRegion::build(const Preparation& preparation, Contributions& contributions) {
  number_nodes(preparation, contributions.registry);
  if (cracks_ && !subdomains_) cracks_->warn_of_gap(mesh_, contributions.warnings);
  const bem::AssemblyOptions assembly{preparation.options.number("bem.quadrature_tolerance"),
                                      preparation.options.whole_number("threads")};
  std::vector<const RegionSubdomains*> lent;
  for (const BoundaryRegion* alike : regions_alike(preparation)) {
    if (alike->subdomains_) lent.push_back(alike->subdomains_.get());
    if (!operator_ && alike->operator_ && differ_by_translation(mesh_, alike->mesh_)) operator_ = alike->operator_;
  }
  if (const BoundaryRegion* before = before_growth(preparation); before && before->subdomains_)
    lent.push_back(before->subdomains_.get());
  if (subdomains_) subdomains_->build(elasticity(), assembly, lent);
  if (cracks_) build_cracks(preparation, assembly);
  if (subdomains_) return;
  if (!operator_) operator_ = make_operator(preparation, assembly);
  // The stiffness may depend on the interfaces of a region, so regions that share an operator may have different
  // stiffnesses.
  stiffness_ = own_stiffness(preparation);
}

std::vector<LeadingElements> BoundaryRegion::leading_elements() const {
  std::vector<LeadingElements> all;
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    if (!panels_[panel].tied) continue;
    LeadingElements leading{panels_[panel].edge, panels_[panel].other_region, {}, {}};
    const auto append = [&](int node) {
      leading.places.push_back(mesh_.nodes[node]);
      leading.nodes.push_back(node_of_mesh_node_[node]);
    };
    for (const BoundaryElement& element : mesh_.elements) {
      if (element.panel != static_cast<int>(panel)) continue;
      if (leading.nodes.empty()) append(element.nodes[0]);
      append(element.nodes[1]);
      append(element.nodes[2]);
    }
    all.push_back(std::move(leading));
  }
  return all;
}

std::vector<Point> BoundaryRegion::places_facing(int other_region) const {
  std::vector<Point> places;
  for (const BoundaryElement& element : mesh_.elements) {
    if (panels_[element.panel].other_region != other_region) continue;
    for (int node : element.nodes) places.push_back(mesh_.nodes[node]);
  }
  return places;
}

bool BoundaryRegion::has_operator_of(const BoundaryRegion& other) const {
  return operator_ && other.operator_ == operator_ && other.stiffness_.size() == stiffness_.size() &&
         (stiffness_.size() == 0 || other.stiffness_ == stiffness_) && other.trace_.rows() == trace_.rows() &&
         other.trace_.cols() == trace_.cols() && other.trace_.isApprox(trace_, 0);
}

std::vector<coupling::DenseOperator> BoundaryRegion::dense_operators(std::span<const RegionOperator> before) const {
  if (subdomains_) {
    auto all = subdomains_->dense_operators(nodes_, trace_, rest_);
    for (const CrackedPart& part : cracked_) {
      coupling::DenseOperator& own = all[part.subdomain];
      own.constraints = part.constraints_for(subdomains_->trace_of_subdomain(part.subdomain, trace_));
      own.pieces = part.pieces([this](int place) { return node_at(place); });
    }
    return all;
  }
  for (const RegionOperator& other : before) {
    if (typeid(*other.region) == typeid(*this) && has_operator_of(static_cast<const BoundaryRegion&>(*other.region)))
      return {{nodes_, other.dense.stiffness, &solution_method(), rest_}};
  }
  if (!cracks_) return {{nodes_, stiffness_of_nodes(), &solution_method(), rest_}};
  const CrackedPart& whole = cracked_.front();
  return {{nodes_, stiffness_of_nodes(), &solution_method(), rest_, whole.constraints_for(trace_),
           whole.pieces([this](int place) { return node_at(place); })}};
}

std::shared_ptr<const Eigen::MatrixXd> BoundaryRegion::stiffness_of_nodes() const {
  // The region's nodes are those of the mesh, in the same order, unless mid nodes are slaved.
  const bool all_nodes = trace_.rows() == trace_.cols();
  if (all_nodes && stiffness_.size() == 0) return {operator_, &operator_->stiffness()};
  if (all_nodes) return std::make_shared<const Eigen::MatrixXd>(stiffness_);
  const Eigen::MatrixXd half = mesh_stiffness() * trace_;
  return std::make_shared<const Eigen::MatrixXd>(trace_.transpose() * half);
}

std::optional<Eigen::VectorXd> BoundaryRegion::outflow(Eigen::Index dof_count) const {
  // A region with cracks is not incompressible as a whole, because opening cracks can take up a change of volume.
  if (!elasticity().incompressible() || cracks_) return std::nullopt;
  Eigen::VectorXd on_mesh = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()));
  bem::add_normal_integrals(mesh_, on_mesh);
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(dof_count);
  scatter(trace_.transpose() * on_mesh, flow);
  return flow;
}

void BoundaryRegion::add_statistics(RegionStatistics& statistics) const {
  statistics.boundary_nodes += static_cast<std::int64_t>(mesh_.nodes.size());
  statistics.boundary_elements += static_cast<std::int64_t>(mesh_.elements.size());
  for (const CrackedPart& part : cracked_)
    statistics.boundary_elements += static_cast<std::int64_t>(part.elements().elements.size());
  statistics.seconds_boundary += seconds_preparing;
  if (subdomains_) return subdomains_->add_statistics(statistics);
  if (statistics.counted.insert(operator_.get()).second)
    statistics.kernel_evaluations += operator_->kernel_evaluations();
}

}  // namespace bempd::regions

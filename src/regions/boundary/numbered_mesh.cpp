#include "regions/boundary/numbered_mesh.hpp"

#include <utility>

#include "regions/crack_crossings.hpp"

namespace bempd::regions {

// Roles of the mesh's nodes. A `shared` node may be a node of other regions, too. The displacement of a `slaved` node
// follows from those of its masters: the mid node of an element on a grid has the mean displacement of the element's
// ends.
struct NumberedMesh::NodeRoles {
  std::vector<char> shared, slaved;
  std::vector<std::vector<std::pair<int, double>>> masters;  // nodes with weights; a master may be slaved, too

  void add(int node, double weight, std::vector<std::pair<int, double>>& to) const {
    if (!slaved[static_cast<std::size_t>(node)]) return to.emplace_back(node, weight), void();
    for (const auto& [master, share] : masters[static_cast<std::size_t>(node)]) add(master, weight * share, to);
  }
};

void NumberedMesh::take(BoundaryMesh mesh, std::vector<PanelSource> panels, const std::vector<Point>& on_cuts,
                        bool middles_follow_ends) {
  mesh_ = std::move(mesh);
  panels_ = std::move(panels);
  places_ = mesh_.nodes;
  places_.insert(places_.end(), on_cuts.begin(), on_cuts.end());
  middles_follow_ends_ = middles_follow_ends;
}

NumberedMesh::NodeRoles NumberedMesh::roles(std::span<const std::array<int, 2>> mouths) const {
  const std::size_t count = mesh_.nodes.size();
  NodeRoles roles{std::vector<char>(count, 0), std::vector<char>(count, 0),
                  std::vector<std::vector<std::pair<int, double>>>(count)};
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    const BoundaryElement& element = mesh_.elements[e];
    const PanelSource& panel = source_of(element);
    if (panel.border == Border::free) continue;
    if (panel.tied) {
      // The nodes at the two ends of a tied interface are nodes of both regions; its other nodes are not.
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
  follow_rows_to_mouths(mouths, roles);
  return roles;
}

// Sets the displacements at mouths of cracks that continue in a lattice. A mouth lies between two material points. At
// the mouth, each face of the crack follows the straight line through the two nearest points on its side; the face is
// free if there is only one point on its side.
void NumberedMesh::follow_rows_to_mouths(std::span<const std::array<int, 2>> mouths, NodeRoles& roles) const {
  const auto lead_to = [&](int mouth, std::size_t element, int step) {
    const BoundaryElement& own = mesh_.elements[element];
    const PanelSource& panel = source_of(own);
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
  for (const auto& [before, behind] : mouths) {
    if (before < 0) continue;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (mesh_.elements[e].nodes[2] == before) lead_to(before, e, -1);
      if (mesh_.elements[e].nodes[0] == behind) lead_to(behind, e, 1);
    }
  }
}

// Side of a crack for each node of the mesh at a mouth that is shared with another boundary element region: 1 left, -1
// right. 0 for all other nodes.
std::vector<int> NumberedMesh::sides_of_cracks(const Preparation& p) const {
  std::vector<int> sides(mesh_.nodes.size(), 0);
  for (const SharedMouth& mouth : shared_mouths(p.cracks)) {
    for (const BoundaryElement& element : mesh_.elements) {
      if (source_of(element).edge == 0) continue;  // on the crack itself
      for (const int node : {element.nodes[0], element.nodes[2]})
        if ((mesh_.nodes[node] - mouth.place).norm() <= 16 * p.tolerance)
          sides[node] = mouth.side_of(mesh_.nodes[element.nodes[1]]);
    }
  }
  return sides;
}

std::vector<int> NumberedMesh::number(const Preparation& preparation, NodeRegistry& registry,
                                      std::span<const std::array<int, 2>> mouths) {
  const std::size_t count = mesh_.nodes.size();
  const NodeRoles roles = this->roles(mouths);
  const std::vector<int> sides = sides_of_cracks(preparation);
  std::vector<int> nodes;
  scene_nodes_.assign(count, -1);
  std::vector<int> column(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (roles.slaved[i]) continue;
    column[i] = static_cast<int>(nodes.size());
    nodes.push_back(roles.shared[i] ? registry.add_shared(mesh_.nodes[i], region_.id(), sides[i])
                                    : registry.add(mesh_.nodes[i]));
    scene_nodes_[i] = nodes.back();
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
  for (std::size_t i = count; i < places_.size(); ++i) {
    for (const int component : {0, 1})
      entries.emplace_back(2 * static_cast<int>(i) + component, 2 * static_cast<int>(nodes.size()) + component, 1.0);
    nodes.push_back(registry.add(places_[i]));
  }
  trace_.resize(2 * static_cast<Eigen::Index>(places_.size()), 2 * static_cast<Eigen::Index>(nodes.size()));
  trace_.setFromTriplets(entries.begin(), entries.end());
  return nodes;
}

// Node of the scene at a place. The nodes on cuts between subdomains are the last nodes of the region.
int NumberedMesh::node_at(int place) const {
  const auto at = static_cast<std::size_t>(place);
  const std::vector<int>& nodes = region_.nodes();
  return at < mesh_.nodes.size() ? scene_nodes_[at] : nodes[nodes.size() - (places_.size() - at)];
}

std::vector<LeadingElements> NumberedMesh::leading_elements() const {
  std::vector<LeadingElements> all;
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    if (!panels_[panel].tied) continue;
    LeadingElements leading{panels_[panel].edge, panels_[panel].other_region, {}, {}};
    const auto append = [&](int node) {
      leading.places.push_back(mesh_.nodes[node]);
      leading.nodes.push_back(scene_nodes_[node]);
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

std::vector<Point> NumberedMesh::places_facing(int other_region) const {
  std::vector<Point> places;
  for (const BoundaryElement& element : mesh_.elements) {
    if (source_of(element).other_region != other_region) continue;
    for (int node : element.nodes) places.push_back(mesh_.nodes[node]);
  }
  return places;
}

}  // namespace bempd::regions

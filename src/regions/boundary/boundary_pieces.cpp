#include <algorithm>

#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"

// Pieces: the separate bodies into which cracks cut a region.
namespace bempd::regions {

namespace {

// Nodes of the scene for all nodes of a mesh, some of which are none (-1). An end of an element at a crack's mouth then
// gets the number of the element's other end, which lies on the same side of the crack; a mid node that of the start.
std::vector<int> with_neighbours(std::vector<int> nodes, const BoundaryMesh& mesh) {
  for (const BoundaryElement& element : mesh.elements)
    for (const int k : {0, 2})
      if (nodes[element.nodes[k]] < 0) nodes[element.nodes[k]] = nodes[element.nodes[2 - k]];
  for (const BoundaryElement& element : mesh.elements)
    if (nodes[element.nodes[1]] < 0) nodes[element.nodes[1]] = nodes[element.nodes[0]];
  return nodes;
}

}  // namespace

// Nodes on cuts between subdomains come last in the region.
int BoundaryRegion::node_at(int place) const {
  const auto at = static_cast<std::size_t>(place);
  return at < mesh_.nodes.size() ? node_of_mesh_node_[at] : nodes_[nodes_.size() - (places().size() - at)];
}

std::vector<int> BoundaryRegion::nodes_of_entries() const { return with_neighbours(node_of_mesh_node_, mesh_); }

bool BoundaryRegion::is_cut() const {
  return std::any_of(cracked_.begin(), cracked_.end(),
                     [](const auto& part) { return part.elements().pieces.count > 1; });
}

bool BoundaryRegion::has_inner_crack(int crack) const {
  return std::any_of(cracked_.begin(), cracked_.end(),
                     [&](const CrackedPart& part) { return part.cracks->has_inside(crack); });
}

InteriorOfPieces BoundaryRegion::inside_without(const LinearBodyForce& particular, const Solution& solution) const {
  if (!subdomains_ && !is_cut()) return InteriorOfPieces(interior_without(particular, solution));
  InteriorOfPieces all;
  if (subdomains_) subdomains_->add_interiors(elasticity(), displacement_without(particular, solution), all);
  const std::vector<bem::CrackedState> states = cracked_states(solution);
  for (std::size_t k = 0; k < cracked_.size(); ++k)
    all.add(*cracked_[k].body, states[k], cracked_[k].cracks->tolerance());
  return all;
}

const CrackLines* BoundaryRegion::crack_lines() const { return cracks_ ? &cracks_->lines() : nullptr; }

std::optional<Overlap> BoundaryRegion::overlap(const Solution& solution) const {
  if (!cracks_ || cracked_.front().closing) return std::nullopt;
  std::optional<Overlap> worst;
  const std::vector<bem::CrackedState> states = cracked_states(solution);
  for (std::size_t k = 0; k < cracked_.size(); ++k) {
    const std::optional<Overlap> own = cracked_[k].cracks->overlap(states[k]);
    if (own && (!worst || own->depth > worst->depth)) worst = own;
  }
  return worst;
}

}  // namespace bempd::regions

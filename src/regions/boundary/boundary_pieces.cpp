#include <algorithm>

#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"

// Pieces: the separate bodies into which cracks cut a region.
namespace bempd::regions {

namespace {

// Factor between two distances that differ by more than rounding. Among nearly equal distances the first counts.
constexpr double clearly_farther = 1 + 1e-6;

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

std::vector<int> BoundaryRegion::nodes_of_entries() const { return with_neighbours(node_of_mesh_node_, mesh_); }

bool BoundaryRegion::is_cut() const {
  return std::any_of(cracked_.begin(), cracked_.end(),
                     [](const auto& part) { return part.elements().pieces.count > 1; });
}

bool BoundaryRegion::has_inner_crack(int crack) const {
  return std::any_of(cracked_.begin(), cracked_.end(),
                     [&](const CrackedPart& part) { return part.cracks->has_inside(crack); });
}

std::vector<coupling::BodyPiece> BoundaryRegion::pieces_of(const CrackedPart& part) const {
  const bem::CrackMesh& cracks = part.elements();
  if (cracks.pieces.count == 1) return {};
  const BoundaryMesh& mesh = part.body->mesh();
  // Nodes of the scene, -1 for nodes that follow others. Nodes on cuts between subdomains come last in the region.
  const auto node_of = [&](std::size_t i) {
    const std::size_t place = part.nodes.empty() ? i : static_cast<std::size_t>(part.nodes[i]);
    return place < mesh_.nodes.size() ? node_of_mesh_node_[place] : nodes_[nodes_.size() - (places().size() - place)];
  };
  std::vector<int> piece_of(mesh.nodes.size(), 0);
  std::vector<char> on_face(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const int node : mesh.elements[e].nodes) {
      piece_of[node] = cracks.pieces.of_element[e];
      if (mesh.elements[e].panel >= cracks.first_face_panel) on_face[node] = 1;
    }
  std::vector<coupling::BodyPiece> pieces(static_cast<std::size_t>(cracks.pieces.count));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    // Nodes away from crack faces are preferred for springs that hold a piece, because contact depends on the
    // displacements of the faces.
    std::vector<std::size_t> own, beside_faces;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      if (node_of(i) < 0 || piece_of[i] != static_cast<int>(p)) continue;
      pieces[p].nodes.push_back(node_of(i));
      own.push_back(i);
      if (!on_face[i]) beside_faces.push_back(i);
    }
    if (beside_faces.size() > 1) own.swap(beside_faces);
    const auto farthest_from = [&](std::size_t from) {
      std::size_t best = own.front();
      const auto way = [&](std::size_t i) { return (mesh.nodes[i] - mesh.nodes[from]).norm(); };
      for (const std::size_t i : own)
        if (way(i) > clearly_farther * way(best)) best = i;
      return best;
    };
    const std::size_t one = farthest_from(own.front()), other = farthest_from(one);
    pieces[p].holdable = {node_of(one), node_of(other)};
  }
  return pieces;
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


#include "error.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/memory_limit.hpp"

// Cracks in subdomains, and the memory that the operators of subdomains need.
namespace bempd::regions {

void RegionSubdomains::require_memory(const scene::Options& options) const {
  double bytes = 0;
  for (const Subdomain& part : subdivision_.subdomains)
    bytes += memory_of_operator(static_cast<double>(part.mesh.elements.size()));
  require_memory_for(bytes, text(traction_nodes_.size(), " boundary elements in ", count(), " subdomains"),
                     "choose longer elements", options);
}

namespace {

// Adds to the region's mesh `body` what cracks have added to a subdomain's mesh: nodes from `first_node` on, at mouths,
// and elements from `first_element` on, which are faces of cracks.
void add_to_body(BoundaryMesh& body, Subdomain& part, std::size_t first_node, std::size_t first_element,
                 const bem::CrackMesh& cracks) {
  for (std::size_t i = first_node; i < part.mesh.nodes.size(); ++i) {
    part.nodes.push_back(static_cast<int>(body.nodes.size()));
    body.nodes.push_back(part.mesh.nodes[i]);
  }
  for (std::size_t e = 0; e < first_element; ++e)
    if (part.elements[e] >= 0)
      for (int k = 0; k < 3; ++k)
        body.elements[static_cast<std::size_t>(part.elements[e])].nodes[k] =
            part.nodes[static_cast<std::size_t>(part.mesh.elements[e].nodes[k])];
  if (first_element == part.mesh.elements.size()) return;
  const int panel = body.elements.back().panel + 1 - cracks.first_face_panel;
  const int first_traction = part.mesh.elements[first_element].traction_nodes[0];
  const int traction = body.traction_node_count - first_traction;
  for (std::size_t e = first_element; e < part.mesh.elements.size(); ++e) {
    BoundaryElement face = part.mesh.elements[e];
    for (int& node : face.nodes) node = part.nodes[static_cast<std::size_t>(node)];
    for (int& node : face.traction_nodes) node += traction;
    face.panel += panel;
    part.elements.push_back(static_cast<int>(body.elements.size()));
    body.elements.push_back(face);
  }
  body.traction_node_count += part.mesh.traction_node_count - first_traction;
}

}  // namespace

std::vector<CrackedPart> RegionSubdomains::mesh_cracks(const RegionCracks& cracks, BoundaryMesh& body) {
  const std::size_t outline = body.nodes.size();
  std::vector<CrackedPart> parts;
  std::vector<std::pair<std::size_t, std::size_t>> first;  // first new node and first new element of each part
  for (std::size_t i = 0; i < count(); ++i) {
    Subdomain& part = subdivision_.subdomains[i];
    if (part.cracks.empty()) continue;
    first.emplace_back(part.mesh.nodes.size(), part.mesh.elements.size());
    parts.emplace_back();
    parts.back().subdomain = i;
    parts.back().cracks = cracks.mesh(part.cracks, part.mesh);
  }
  std::size_t added = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) added += mesh_of(parts[k].subdomain).nodes.size() - first[k].first;
  for (Subdomain& part : subdivision_.subdomains)
    for (int& node : part.nodes)
      if (static_cast<std::size_t>(node) >= outline) node += static_cast<int>(added);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Subdomain& part = subdivision_.subdomains[parts[k].subdomain];
    add_to_body(body, part, first[k].first, first[k].second, parts[k].elements());
    parts[k].nodes = part.nodes;
  }
  number(body);
  return parts;
}

}  // namespace bempd::regions

#include <algorithm>

#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/memory_limit.hpp"

// Subdomains: parts with operators of their own, into which a large region is cut. Cracks lie inside subdomains.
namespace bempd::regions {

void RegionSubdomains::require_memory(const scene::Options& options) const {
  double bytes = 0;
  for (const Subdomain& part : subdivision_.subdomains)
    bytes += memory_of_operator(static_cast<double>(part.mesh.elements.size()));
  require_memory_for(bytes, text(traction_nodes_.size(), " boundary elements in ", count(), " subdomains"),
                     "choose longer elements", options);
}

namespace {

// Adds to the body's mesh what a subdomain has behind its first nodes and elements: nodes at mouths of cracks, and
// faces of cracks.
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
  std::vector<std::pair<std::size_t, std::size_t>> first;  // new node and element of each part
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

double BoundaryRegion::memory_of_preparing(double times) const {
  const auto elements = static_cast<double>(mesh_.elements.size());
  if (!cracks_ || subdomains_) return least_memory_of_region(times * elements);
  return RegionCracks::memory_of(times * (elements + cracks_->elements_on_cracks()));
}

const std::vector<Point>& BoundaryRegion::places() const { return subdomains_ ? subdomains_->places() : mesh_.nodes; }

// The region in the scene with shorter cracks; null without that.
const BoundaryRegion* BoundaryRegion::before_growth(const Preparation& preparation) const {
  if (!preparation.before) return nullptr;
  for (const auto& region : *preparation.before)
    if (region->id() == id()) return static_cast<const BoundaryRegion*>(region.get());
  return nullptr;
}

BoundaryMesh BoundaryRegion::mesh_without_cracks(const Preparation& preparation) const {
  BoundaryPanels panels = mesh_edges(preparation, meshing_rules(preparation), id());
  halve_elements(preparation, id(), panels);
  return make_mesh(panels.loops);
}

void BoundaryRegion::cut_if_large(const Preparation& preparation) {
  if (can_be_cut() && !elasticity().incompressible() && !(cracks_ && cracks_->continue_elsewhere())) {
    if (!cracks_) {
      subdomains_ = RegionSubdomains::of(mesh_, preparation.options);
    } else {
      const BoundaryRegion* before = before_growth(preparation);
      subdomains_ = RegionSubdomains::around(cracks_->places(), mesh_, mesh_without_cracks(preparation),
                                             preparation.options, before ? before->subdomains_.get() : nullptr);
    }
  }
  if (subdomains_) return subdomains_->require_memory(preparation.options);
  if (cracks_) return;
  const auto elements = static_cast<double>(mesh_.elements.size());
  if (const double bytes = memory_of_operator(elements); bytes > least_memory_of_region(elements))
    require_memory_for(bytes, text("the ", elements, " boundary elements of region ", id(), " in one piece"),
                       "choose longer elements, or divide the region into several", preparation.options);
}

void BoundaryRegion::mesh_cracks(const Preparation& preparation) {
  if (subdomains_) {
    cracked_ = subdomains_->mesh_cracks(*cracks_, mesh_);
  } else {
    cracked_.emplace_back();
    cracked_.back().cracks = cracks_->mesh(mesh_);
    cracks_->require_memory(mesh_, preparation.options);
  }
  // Panels of crack faces come from no edge: their source has the edge number 0.
  if (!mesh_.elements.empty())
    panels_.resize(static_cast<std::size_t>(mesh_.elements.back().panel) + 1, {0, 0, 1, Border::free, 0, false});
}

// The part that had the same cracks before they grew; null without that.
const CrackedPart* BoundaryRegion::part_before(const Preparation& preparation, const CrackedPart& part) const {
  const BoundaryRegion* before = before_growth(preparation);
  if (!before) return nullptr;
  const auto found = std::find_if(before->cracked_.begin(), before->cracked_.end(),
                                  [&](const CrackedPart& one) { return part.shares_crack_with(one); });
  return found == before->cracked_.end() ? nullptr : &*found;
}

void BoundaryRegion::build_cracks(const Preparation& preparation, const bem::AssemblyOptions& assembly) {
  const bool faces_close = preparation.options.text_value("contact") == "faces";
  for (CrackedPart& part : cracked_) {
    const BoundaryMesh& mesh = subdomains_ ? subdomains_->mesh_of(part.subdomain) : mesh_;
    part.build(mesh, elasticity(), assembly, faces_close, part_before(preparation, part));
    if (subdomains_) {
      subdomains_->set_operator(part.subdomain, part.body);
    } else {
      operator_ = part.body;
    }
  }
}

std::vector<OperatorNodes> BoundaryRegion::nodes_of_operators() const {
  if (!subdomains_) return {{nodes_, rest_}};
  return subdomains_->nodes_of_operators(nodes_, trace_, rest_);
}

}  // namespace bempd::regions

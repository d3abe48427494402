#include "regions/boundary/boundary_parts.hpp"

#include <algorithm>

#include "error.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::regions {

BoundaryPanels BoundaryParts::find_cracks(const Preparation& preparation, const MeshingRules& rules) {
  const int id = region_.id();
  cracks_ = cracks_of(preparation, id);
  BoundaryPanels panels = mesh_edges(preparation, rules, id, cracks_ ? cracks_->mouths() : std::vector<Point>());
  refine_at_cracks(preparation, cracks_.get(), panels);
  halve_elements(preparation, id, panels);
  return panels;
}

// Mesh of the region as it would be without its cracks, except that elements are graded towards the cracks if the mesh
// has grading. Without grading the mesh is that of `before`, if there is one.
BoundaryMesh BoundaryParts::uncracked(const Preparation& preparation, const BoundaryMethod& method,
                                      const RegionSubdomains* before) const {
  const MeshingRules rules = method.meshing_rules(preparation.options);
  if (before && before->uncracked() && !rules.grade_corners) return *before->uncracked();
  BoundaryPanels panels = mesh_edges(preparation, rules, region_.id());
  halve_elements(preparation, region_.id(), panels);
  return method.make_mesh(panels.loops);
}

void BoundaryParts::cut_if_large(const Preparation& preparation, const BoundaryMethod& method, const BoundaryMesh& mesh,
                                 const BoundaryParts* before) {
  const scene::Options& options = preparation.options;
  const bool can_be_cut = method.cuts_large_regions() && !region_.elasticity().incompressible() &&
                          !(cracks_ && cracks_->continue_elsewhere());
  if (can_be_cut && !cracks_) {
    subdomains_ = RegionSubdomains::of(mesh, options);
  } else if (can_be_cut) {
    const RegionSubdomains* const cut_before = before ? before->subdomains() : nullptr;
    subdomains_ = RegionSubdomains::around(cracks_->places(), mesh, uncracked(preparation, method, cut_before), options,
                                           cut_before);
  }
  if (subdomains_) return subdomains_->require_memory(options);
  if (cracks_) return;
  const auto elements = static_cast<double>(mesh.elements.size());
  if (const double bytes = memory_of_operator(elements); bytes > least_memory_of_region(elements))
    require_memory_for(bytes, text("the ", elements, " boundary elements of region ", region_.id(), " in one piece"),
                       "choose longer elements, or divide the region into several", options);
}

void BoundaryParts::mesh_cracks(const scene::Options& options, BoundaryMesh& mesh, std::vector<PanelSource>& panels) {
  if (!cracks_) return;
  if (subdomains_) {
    cracked_ = subdomains_->mesh_cracks(*cracks_, mesh);
  } else {
    cracked_.emplace_back();
    cracked_.back().cracks = cracks_->mesh(mesh);
    cracks_->require_memory(mesh, options);
  }
  // Panels of crack faces come from no edge: their source has the edge number 0.
  if (!mesh.elements.empty())
    panels.resize(static_cast<std::size_t>(mesh.elements.back().panel) + 1, {0, 0, 1, Border::free, 0, false});
}

// Part with cracks that, before growth, had elements on a crack of the given part; null if there is none.
const CrackedPart* BoundaryParts::part_before(const CrackedPart& part, const BoundaryParts* before) const {
  if (!before) return nullptr;
  const auto found = std::find_if(before->cracked_.begin(), before->cracked_.end(),
                                  [&](const CrackedPart& one) { return part.shares_crack_with(one); });
  return found == before->cracked_.end() ? nullptr : &*found;
}

void BoundaryParts::build(const Preparation& preparation, const bem::AssemblyOptions& assembly,
                          const BoundaryMesh& mesh, const std::vector<const RegionSubdomains*>& lent,
                          const BoundaryParts* before) {
  if (subdomains_) subdomains_->build(region_.elasticity(), assembly, lent);
  const bool faces_close = preparation.options.text_value("contact") == "faces";
  for (CrackedPart& part : cracked_) {
    const BoundaryMesh& own = subdomains_ ? subdomains_->mesh_of(part.subdomain) : mesh;
    part.build(own, region_.elasticity(), assembly, faces_close, part_before(part, before));
    if (subdomains_) subdomains_->set_operator(part.subdomain, part.body);
  }
}

bool BoundaryParts::are_in_pieces() const {
  return std::any_of(cracked_.begin(), cracked_.end(),
                     [](const auto& part) { return part.elements().pieces.count > 1; });
}

std::span<const std::array<int, 2>> BoundaryParts::mouths() const {
  if (!is_whole_with_cracks()) return {};
  return cracked_.front().elements().mouth_of_joint;
}

void BoundaryParts::warn_of_gap(const BoundaryMesh& mesh, std::vector<std::string>& warnings) const {
  if (is_whole_with_cracks()) cracks_->warn_of_gap(mesh, warnings);
}

double BoundaryParts::memory_of_preparing(double elements, double times) const {
  if (!is_whole_with_cracks()) return least_memory_of_region(times * elements);
  return RegionCracks::memory_of(times * (elements + cracks_->elements_on_cracks()));
}

}  // namespace bempd::regions

#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "regions/boundary/boundary_method.hpp"
#include "regions/boundary/cracked_part.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"

namespace bempd::regions {

// Parts of a boundary element region that have operators of their own: the subdomains into which a large region is cut,
// and the parts with cracks. A part with cracks is a subdomain, or the whole region if the region is not cut.
class BoundaryParts {
 public:
  explicit BoundaryParts(const Region& region) : region_(region) {}

  // --- Preparation, in this order. `before` are the parts of the region before its cracks grew; null if there are
  // none.

  // Finds the region's cracks, and makes the panels of the region's edges, which end at the mouths of cracks.
  BoundaryPanels find_cracks(const Preparation& preparation, const MeshingRules& rules);
  // Cuts the region with this mesh into subdomains if it is large and the method allows cuts.
  void cut_if_large(const Preparation& preparation, const BoundaryMethod& method, const BoundaryMesh& mesh,
                    const BoundaryParts* before);
  // Meshes the cracks, which adds nodes and faces to the region's mesh.
  void mesh_cracks(const scene::Options& options, BoundaryMesh& mesh, std::vector<PanelSource>& panels);
  // Builds the operators of subdomains and of parts with cracks. Operators that subdomains in `lent` already have are
  // used again.
  void build(const Preparation& preparation, const bem::AssemblyOptions& assembly, const BoundaryMesh& mesh,
             const std::vector<const RegionSubdomains*>& lent, const BoundaryParts* before);

  // --- Parts

  const RegionCracks* cracks() const { return cracks_.get(); }              // null if there are none
  const RegionSubdomains* subdomains() const { return subdomains_.get(); }  // null if one operator serves the region
  const std::vector<CrackedPart>& cracked() const { return cracked_; }
  bool is_whole_with_cracks() const { return cracks_ && !subdomains_; }
  // Whether cracks cut the region, or a subdomain of it, into pieces.
  bool are_in_pieces() const;
  // Nodes of the mesh before and behind the mouth at each joint of cracks (place where cracks meet each other or, at a
  // mouth, the boundary); negative numbers for a joint inside the region. Empty if the region has no cracks, or is cut
  // into subdomains, whose cracks do not continue in a lattice.
  std::span<const std::array<int, 2>> mouths() const;
  // Adds a warning if a narrow gap beside a crack takes many elements; only for a region that is not cut into
  // subdomains.
  void warn_of_gap(const BoundaryMesh& mesh, std::vector<std::string>& warnings) const;
  // Estimated memory [B] for preparing the region after the number of its elements has been multiplied by `times`. The
  // region has `elements` elements on its boundary before.
  double memory_of_preparing(double elements, double times) const;

 private:
  BoundaryMesh uncracked(const Preparation& preparation, const BoundaryMethod& method,
                         const RegionSubdomains* before) const;
  const CrackedPart* part_before(const CrackedPart& part, const BoundaryParts* before) const;

  const Region& region_;
  std::unique_ptr<RegionCracks> cracks_;
  std::unique_ptr<RegionSubdomains> subdomains_;
  std::vector<CrackedPart> cracked_;
};

}  // namespace bempd::regions

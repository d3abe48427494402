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

// Parts of a boundary element region with operators of their own: subdomains, into which a large region is cut, and
// what contains cracks, which is one or more of the subdomains or the whole region.
class BoundaryParts {
 public:
  explicit BoundaryParts(const Region& region) : region_(region) {}

  // --- Preparation, in this order; `before` are the parts of the region with shorter cracks, null without that.

  // Finds the region's cracks, and makes the panels of its edges, which end at their mouths.
  BoundaryPanels find_cracks(const Preparation& preparation, const MeshingRules& rules);
  // Cuts the region with this mesh into subdomains if it is large and the method does that.
  void cut_if_large(const Preparation& preparation, const BoundaryMethod& method, const BoundaryMesh& mesh,
                    const BoundaryParts* before);
  // Meshes the cracks, which adds nodes and faces to the region's mesh.
  void mesh_cracks(const scene::Options& options, BoundaryMesh& mesh, std::vector<PanelSource>& panels);
  // Builds the operators of subdomains, some of which the subdomains `lent` already have, and of parts with cracks.
  void build(const Preparation& preparation, const bem::AssemblyOptions& assembly, const BoundaryMesh& mesh,
             const std::vector<const RegionSubdomains*>& lent, const BoundaryParts* before);

  // --- Parts

  const RegionCracks* cracks() const { return cracks_.get(); }              // null without
  const RegionSubdomains* subdomains() const { return subdomains_.get(); }  // null if one operator serves the region
  const std::vector<CrackedPart>& cracked() const { return cracked_; }
  bool is_whole_with_cracks() const { return cracks_ && !subdomains_; }
  // Whether cracks cut the region, or a subdomain of it, into pieces.
  bool are_in_pieces() const;
  // Pairs of the mesh's nodes at joints of cracks that may continue in a lattice, which those in subdomains do not.
  std::span<const std::array<int, 2>> mouths() const;
  // Adds a warning if there are many elements in a narrow gap beside a crack of a region in one part.
  void warn_of_gap(const BoundaryMesh& mesh, std::vector<std::string>& warnings) const;
  // Estimated memory [B] that preparing takes with `times` the number of `elements` on the boundary.
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

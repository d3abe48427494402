#pragma once

#include <memory>

#include "regions/boundary/boundary_cracks.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/boundary_loads.hpp"
#include "regions/boundary/boundary_results.hpp"

namespace bempd::regions {

// Boundary element region: its mesh and nodes, its operators, and the loads and results that follow from them. The
// scheme chooses the method.
class BoundaryRegion final : public Region {
 public:
  BoundaryRegion(int id, const scene::Material& material, std::unique_ptr<const BoundaryMethod> method);

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;

  const RegionLoads& loads() const override { return loads_; }
  const RegionResults& results() const override { return results_; }
  const BoundaryOperators* operators() const override { return &operators_; }
  const CrackElements* crack_elements() const override { return method_->has_crack_elements() ? &cracks_ : nullptr; }
  const ElementBorders* element_borders() const override { return &mesh_; }
  RegionSwelling* swelling() override { return &swelling_; }
  void add_statistics(RegionStatistics& statistics) const override;

 private:
  std::unique_ptr<const BoundaryMethod> method_;
  NumberedMesh mesh_;
  BoundarySwelling swelling_;
  BoundaryParts parts_;
  BoundaryOperators operators_;
  ParticularSolutions particulars_;
  BoundaryLoads loads_;
  BoundaryStates states_;
  BoundaryCracks cracks_;
  BoundaryResults results_;
};

}  // namespace bempd::regions

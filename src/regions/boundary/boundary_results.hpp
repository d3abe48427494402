#pragma once

#include "regions/boundary/boundary_states.hpp"

namespace bempd::regions {

// Fields on the boundary of a boundary element region, and values at places inside the region.
class BoundaryResults final : public RegionResults {
 public:
  BoundaryResults(const Region& region, const NumberedMesh& mesh, const BoundarySwelling& swelling,
                  const ParticularSolutions& particulars, const BoundaryStates& states)
      : region_(region), mesh_(mesh), swelling_(swelling), particulars_(particulars), states_(states) {}

  std::vector<int> entries_of_nodes() const override;
  std::vector<int> nodes_of_entries() const override;
  FieldSize field_size(Field field) const override;
  FieldValues field(Field field, const Solution& solution) const override;
  std::int64_t cell_count() const override { return static_cast<std::int64_t>(mesh_.mesh().elements.size()); }
  Cells cells() const override;
  SnapshotBlock snapshot_block() const override;
  bool has_inside() const override { return true; }
  FieldValues at_nodes(Field field, const FieldValues& values) const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;
  int rank_at_interfaces() const override { return 1; }

 private:
  FieldValues element_tractions(const Solution& solution) const;
  FieldValues element_stress(const Solution& solution) const;

  const Region& region_;
  const NumberedMesh& mesh_;
  const BoundarySwelling& swelling_;
  const ParticularSolutions& particulars_;
  const BoundaryStates& states_;
};

}  // namespace bempd::regions

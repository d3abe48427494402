#pragma once

#include "regions/boundary/boundary_states.hpp"

namespace bempd::regions {

// Cracks with elements in a boundary element region: loads on crack faces, tips, openings.
class BoundaryCracks final : public CrackElements {
 public:
  BoundaryCracks(const Region& region, const NumberedMesh& mesh, const BoundaryParts& parts,
                 const ParticularSolutions& particulars, const BoundaryStates& states)
      : region_(region), mesh_(mesh), parts_(parts), particulars_(particulars), states_(states) {}

  const CrackLines* lines() const override { return parts_.cracks() ? &parts_.cracks()->lines() : nullptr; }
  bool cut_the_region() const override { return parts_.are_in_pieces(); }
  bool lie_inside(int crack) const override;
  void add_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const override;
  coupling::Affine face_offsets(const std::array<BodyForce, 2>& body_force,
                                const std::vector<CrackLoad>& crack_loads) const override;
  std::vector<TipValues> tips(const Solution& solution, TipDetail detail) const override;
  std::vector<Point> openings(int crack, const std::vector<double>& fractions, const Solution& solution) const override;
  std::vector<CrackPicture> pictures(const Solution& solution) const override;
  std::optional<Overlap> overlap(const Solution& solution) const override;

 private:
  const Region& region_;
  const NumberedMesh& mesh_;
  const BoundaryParts& parts_;
  const ParticularSolutions& particulars_;
  const BoundaryStates& states_;
};

}  // namespace bempd::regions

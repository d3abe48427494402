#pragma once

#include "coupling/affine.hpp"
#include "regions/boundary/numbered_mesh.hpp"

namespace bempd::regions {

// Free swelling of a boundary element region.
class BoundarySwelling final : public RegionSwelling {
 public:
  BoundarySwelling(const Region& region, const NumberedMesh& mesh) : region_(region), mesh_(mesh) {}

  // Sets the swelling strain. Throws Error (argument) for a strain that is not linear in x and y, because it causes
  // stress in the interior.
  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;
  // Rest displacements of the region's nodes (in free swelling); no rows if the region does not swell.
  const coupling::Affine& rest() const { return rest_; }

 private:
  const Region& region_;
  const NumberedMesh& mesh_;
  std::optional<FreeSwelling> free_swelling_;
  coupling::Affine rest_{0, 2};
};

}  // namespace bempd::regions

#pragma once

#include "regions/lattice/lattice_swelling.hpp"
#include "regions/lattice/scene_bonds.hpp"
#include "regions/region_swelling.hpp"

namespace bempd::regions {

// Swelling of a peridynamic region, which sets the rest elongations of the region's bonds and cell squares.
class BondedSwelling final : public RegionSwelling {
 public:
  BondedSwelling(const BondedRegion& region, const SceneBonds& bonds) : region_(region), bonds_(bonds) {}

  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;

 private:
  // Swelling strains (constant and proportional part) at the region's points, followed by those at points of other
  // regions at which its bonds end.
  std::vector<Eigen::RowVector2d> strains_of_points(const LatticeSwelling& lattices) const;

  const BondedRegion& region_;  // which tells with which regions it shares bonds
  const SceneBonds& bonds_;
  bool is_swollen_ = false;
  std::optional<FreeSwelling> free_swelling_;  // empty if the region cannot swell freely
};

}  // namespace bempd::regions

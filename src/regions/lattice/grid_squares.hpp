#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "pd/cell_lattice.hpp"
#include "regions/lattice/material_points.hpp"
#include "regions/lattice/region_squares.hpp"
#include "regions/lattice/scene_bonds.hpp"

namespace bempd::regions {

// Cell squares (energy terms of cells, for other Poisson's ratios than that of bonds) of a region whose cells form a
// regular grid.
class GridSquares final : public RegionSquares {
 public:
  GridSquares(const PlaneElasticity& elasticity, const MaterialPoints& points, const pd::CellLattice& grid,
              const SceneBonds& bonds)
      : elasticity_(elasticity), points_(points), grid_(grid), bonds_(bonds) {}

  void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const override;
  // Corrects the stress at points that have lost bonds or cell squares: the stress of the bonds, plus the mean over the
  // cells at the point of the stress in intact cell squares.
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const override;

 private:
  Eigen::Vector3d stress(const Solution& solution, int first_square) const;

  const PlaneElasticity& elasticity_;
  const MaterialPoints& points_;
  const pd::CellLattice& grid_;
  const SceneBonds& bonds_;
};

}  // namespace bempd::regions

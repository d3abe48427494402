#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "pd/cell_lattice.hpp"
#include "regions/lattice/material_points.hpp"
#include "regions/lattice/region_squares.hpp"
#include "regions/lattice/scene_bonds.hpp"

namespace bempd::regions {

// Cell squares (extra energy terms of lattice cells, for Poisson's ratios that bonds alone cannot have) of a region
// whose cells form a regular grid.
class GridSquares final : public RegionSquares {
 public:
  GridSquares(const PlaneElasticity& elasticity, const MaterialPoints& points, const pd::CellLattice& grid,
              const SceneBonds& bonds)
      : elasticity_(elasticity), points_(points), grid_(grid), bonds_(bonds) {}

  void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const override;
  // Corrects the stress at each point that has lost bonds or cell squares. The corrected stress is that of the bonds
  // plus that of the intact cell squares, the latter as a mean over the cells around the point.
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

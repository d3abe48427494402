#pragma once

#include <functional>

#include "elasticity/plane_elasticity.hpp"
#include "pd/outlined/cell_stencils.hpp"
#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/region_squares.hpp"
#include "regions/lattice/scene_bonds.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Adds the squares of all patches of cells of a body to the scene's terms, behind the bonds, and returns the first of
// each patch. `node` maps points of the body to the scene's nodes, `term` maps bonds of the body to the scene's terms.
std::vector<int> add_squares(const pd::CellStencils& stencils, const PlaneElasticity& elasticity, double spacing,
                             const std::function<int(int)>& node, const std::function<int(int)>& term,
                             const Contributions& contributions);

// Whether the squares of the patches of a body make its material.
inline bool reproduce_material(const pd::CellStencils& stencils) { return stencils.max_residual < 1e-11; }

// Squares of the patches of cells at the points of a region with any outline; none where bonds alone make the material.
class StencilSquares final : public RegionSquares {
 public:
  StencilSquares(const PlaneElasticity& elasticity, double spacing, const pd::OutlinedBody& body,
                 const SceneBonds& bonds)
      : elasticity_(elasticity), spacing_(spacing), body_(body), bonds_(bonds) {}

  const pd::CellStencils& stencils() const { return stencils_; }
  void set_stencils(pd::CellStencils stencils) { stencils_ = std::move(stencils); }

  // The stress-free displacement of a linear strain, e = e0 + a x + b y, is (e0 x + a (x^2 - y^2) / 2 + b x y,
  // e0 y + a x y + b (y^2 - x^2) / 2); the rest elongations are those of it.
  void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const override;
  // Corrects the stress at points that have lost squares: it becomes the mean of what the remaining bonds and squares
  // carry, over the cells at the point, weighted by their shares of its area.
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const override;

 private:
  // Mean stress [Pa] that the squares cause in a patch of cells.
  Eigen::Vector3d stress(const Solution& solution, std::size_t patch) const;

  const PlaneElasticity& elasticity_;
  double spacing_;  // [m]
  const pd::OutlinedBody& body_;
  const SceneBonds& bonds_;
  pd::CellStencils stencils_;
};

}  // namespace bempd::regions

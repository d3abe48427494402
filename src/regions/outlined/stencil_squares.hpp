#pragma once

#include <functional>

#include "elasticity/plane_elasticity.hpp"
#include "pd/outlined/cell_stencils.hpp"
#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/region_squares.hpp"
#include "regions/lattice/scene_bonds.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Adds the cell squares (energy terms that correct Poisson's ratio) of all patches (groups of cells) of a body to the
// scene's energy terms. Returns the number of the first cell square of each patch. `node` maps points of the body to
// the scene's nodes, `term` maps bonds of the body to the scene's terms.
std::vector<int> add_squares(const pd::CellStencils& stencils, const PlaneElasticity& elasticity, double spacing,
                             const std::function<int(int)>& node, const std::function<int(int)>& term,
                             const Contributions& contributions);

// Whether bonds and cell squares together reproduce the elasticity of the material.
inline bool reproduce_material(const pd::CellStencils& stencils) { return stencils.max_residual < 1e-11; }

// Cell squares of a region with an outline of any shape, by patches (groups of cells). There are none if bonds alone
// reproduce the elasticity of the material.
class StencilSquares final : public RegionSquares {
 public:
  StencilSquares(const PlaneElasticity& elasticity, double spacing, const pd::OutlinedBody& body,
                 const SceneBonds& bonds)
      : elasticity_(elasticity), spacing_(spacing), body_(body), bonds_(bonds) {}

  const pd::CellStencils& stencils() const { return stencils_; }
  void set_stencils(pd::CellStencils stencils) { stencils_ = std::move(stencils); }

  // Rest elongations are those of the displacement under which a swelling strain causes no stress. For a strain that is
  // linear over a patch, e = e0 + a x + b y, this displacement is
  //   (e0 x + a (x^2 - y^2) / 2 + b x y, e0 y + a x y + b (y^2 - x^2) / 2).
  void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const override;
  // Replaces the stress at each point that has lost bonds or cell squares by the stress of its bonds, plus the mean
  // stress that intact cell squares cause in the patches at the point, weighted by their shares of the point's area.
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const override;

 private:
  // Mean stress [Pa] that cell squares cause in a patch.
  Eigen::Vector3d stress(const Solution& solution, std::size_t patch) const;

  const PlaneElasticity& elasticity_;
  double spacing_;  // [m]
  const pd::OutlinedBody& body_;
  const SceneBonds& bonds_;
  pd::CellStencils stencils_;
};

}  // namespace bempd::regions

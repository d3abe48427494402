#pragma once

#include <vector>

#include "coupling/terms.hpp"
#include "pd/deformation.hpp"
#include "regions/fields.hpp"

namespace bempd::regions {

// Cell squares of a peridynamic region: extra energy terms of its lattice cells, for Poisson's ratios that bonds alone
// cannot have.
class RegionSquares {
 public:
  virtual ~RegionSquares() = default;

  // Sets the rest elongations of cell squares for swelling strains (constant and proportional part) at the region's
  // points.
  virtual void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const = 0;
  // Replaces the stress at each point that has lost bonds or cell squares by the stress of its bonds plus that of the
  // intact cell squares around the point.
  virtual void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                 const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const = 0;
};

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "coupling/operators.hpp"
#include "pd/deformation.hpp"
#include "regions/fields.hpp"

namespace bempd::regions {

// Squares of the cells of a peridynamic region: terms of the energy that make any Poisson's ratio possible.
class RegionSquares {
 public:
  virtual ~RegionSquares() = default;

  // Sets the rest elongations of squares for swelling strains (constant and proportional part) at the region's points.
  virtual void set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const = 0;
  // Replaces the stresses of points at which bonds or squares are broken: by that of the bonds, plus that of the intact
  // squares around the point.
  virtual void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                 const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const = 0;
};

}  // namespace bempd::regions

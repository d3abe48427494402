#pragma once

#include <optional>

#include "coupling/operators.hpp"
#include "elasticity/free_swelling.hpp"

namespace bempd::regions {

class LatticeSwelling;

// Swelling of a region: strains of the free material, caused by temperature; set before operators are asked for.
class RegionSwelling {
 public:
  virtual ~RegionSwelling() = default;

  // Takes a swelling strain. Throws Error (argument) if the region cannot swell in that way.
  virtual void swell(const Swelling& strain, LatticeSwelling& lattices) = 0;
  // Sets the rest elongations of the region's terms, if it has terms. Called after swell() of all regions.
  virtual void set_rests(const LatticeSwelling& /*lattices*/, coupling::Terms& /*terms*/) const {}
  // Displacement when the region swells freely (columns: constant, proportional part); empty if that causes stress.
  virtual std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const = 0;
};

}  // namespace bempd::regions

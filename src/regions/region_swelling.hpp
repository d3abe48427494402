#pragma once

#include <optional>

#include "coupling/terms.hpp"
#include "elasticity/free_swelling.hpp"

namespace bempd::regions {

class LatticeSwelling;

// Swelling of a region: strains that a change of temperature causes in the free material. They are set before the
// region's operators are made.
class RegionSwelling {
 public:
  virtual ~RegionSwelling() = default;

  // Sets the swelling strain. Throws Error (argument) if the region cannot represent this field of strains.
  virtual void swell(const Swelling& strain, LatticeSwelling& lattices) = 0;
  // Sets the rest elongations of the region's energy terms (bonds and cell squares), if it has any. The function is
  // called after swell() of all regions.
  virtual void set_rests(const LatticeSwelling& /*lattices*/, coupling::Terms& /*terms*/) const {}
  // Displacement of a place when the region swells freely (columns: constant, proportional part); empty if free
  // swelling causes stress.
  virtual std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const = 0;
};

}  // namespace bempd::regions

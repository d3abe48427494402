#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/free_swelling.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

class BondedRegion;

// Swelling strains at the nodes of lattices. Regions that share bonds have one field of strains. At a node of several
// regions the field is the mean of the regions' strains, weighted by the regions' shares of the node's area.
class LatticeSwelling {
 public:
  explicit LatticeSwelling(const std::vector<Point>& positions) : positions_(positions) {}

  void add(const BondedRegion& region, const Swelling& strain);
  // Swelling strain at a node of a region: constant and proportional part.
  Eigen::RowVector2d at(const BondedRegion& region, int node) const;

 private:
  // Field of strains of the regions that share bonds with the region `first`. At each node, `sum` is the sum of strains
  // times the regions' shares of area, and `weight` is the sum of these shares.
  struct Body {
    const BondedRegion* first;
    coupling::Affine sum;
    std::vector<double> weight;
  };

  const Body& body_of(const BondedRegion& region) const;

  const std::vector<Point>& positions_;
  std::vector<Body> bodies_;
};

}  // namespace bempd::regions

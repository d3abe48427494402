#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/free_swelling.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

class BondedRegion;

// Swelling strains of lattices at the scene's nodes: one field for all regions that act as one where they touch, since
// bonds cross from one to the other; the mean of their strains where these differ.
class LatticeSwelling {
 public:
  explicit LatticeSwelling(const std::vector<Point>& positions) : positions_(positions) {}

  void add(const BondedRegion& region, const Swelling& strain);
  // Strain at a node, constant and proportional part.
  Eigen::RowVector2d at(const BondedRegion& region, int node) const;

 private:
  struct Body {
    const BondedRegion* first;
    coupling::Affine sum;
    std::vector<int> count;
  };

  const Body& body_of(const BondedRegion& region) const;

  const std::vector<Point>& positions_;
  std::vector<Body> bodies_;
};

}  // namespace bempd::regions

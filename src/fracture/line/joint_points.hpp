#pragma once

#include <vector>

#include "fracture/line/near_points.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Material points near borders behind which boundary elements of the same material continue the body.
class JointPoints {
 public:
  JointPoints(const std::vector<Point>& positions, const NearPoints& near, const pd::TipLaws& laws);

  // Whether a point is so close to a border with boundary elements that the bonds of the point do not give its stress.
  bool are_beside(int node) const { return beside_[static_cast<std::size_t>(node)] != 0; }

 private:
  std::vector<char> beside_;
};

}  // namespace bempd::fracture

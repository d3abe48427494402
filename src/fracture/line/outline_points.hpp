#pragma once

#include <vector>

#include "coupling/terms.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Material points on the outline of lattices, with the share of a full point's area that each has: half on a straight
// edge, a quarter at a corner.
class OutlinePoints {
 public:
  OutlinePoints(const coupling::Terms& terms, const pd::TipLaws& laws, std::size_t nodes);

  bool has(int node) const { return share_[static_cast<std::size_t>(node)] > 0; }
  double share_of(int node) const { return has(node) ? share_[static_cast<std::size_t>(node)] : 1; }

 private:
  std::vector<double> share_;  // 0 inside
};

}  // namespace bempd::fracture

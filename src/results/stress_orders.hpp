#pragma once

#include "geometry/box_tree.hpp"
#include "regions/singular_places.hpp"

namespace bempd::results {

// Search for places at which stress is unbounded, and for the order of the stress singularity there.
class StressOrders {
 public:
  // Prepares the search. `places` must outlive this object; a point closer than `tolerance` to one of `places` counts
  // as lying there.
  StressOrders(const std::vector<regions::SingularPlace>& places, double tolerance);

  // Order of the stress singularity at a place: stress grows as r^-order; 0 where stress is bounded.
  double order_at(const Point& place) const;
  // Orders of the stress singularity at nodes, given by their positions.
  regions::FieldValues at_nodes(const regions::FieldValues& positions) const;

 private:
  const regions::SingularPlace* at(const Point& place) const;

  const std::vector<regions::SingularPlace>& places_;
  double reach_;
  BoxTree tree_;
};

}  // namespace bempd::results

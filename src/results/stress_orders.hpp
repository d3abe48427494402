#pragma once

#include "geometry/box_tree.hpp"
#include "regions/singular_places.hpp"

namespace bempd::results {

// Finds the places at which stress is unbounded, and the order of each.
class StressOrders {
 public:
  // `places` stay with the caller; what is closer than some `tolerance` is the same place.
  StressOrders(const std::vector<regions::SingularPlace>& places, double tolerance);

  // Order of the stress at a place or at nodes: 0 where it is bounded; else stress grows as r to the power of minus
  // this.
  double order_at(const Point& place) const;
  regions::FieldValues at_nodes(const regions::FieldValues& positions) const;

 private:
  const regions::SingularPlace* at(const Point& place) const;

  const std::vector<regions::SingularPlace>& places_;
  double reach_;
  BoxTree tree_;
};

}  // namespace bempd::results

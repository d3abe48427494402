#pragma once

#include <vector>

#include "coupling/constraints.hpp"
#include "geometry/point.hpp"

namespace bempd::coupling {

// Whether crack faces among bonds press on each other at a place: whether the nearest constraint with a penalty is
// closed. False if no such constraint is closer than `within`.
inline bool faces_press_at(const Constraints& constraints, const std::vector<Point>& positions, const Point& place,
                           double within) {
  if (constraints.closed_penalty_count() == 0) return false;
  double nearest = within;
  bool presses = false;
  for (std::size_t i = constraints.exact_count(); i < constraints.size(); ++i) {
    const std::vector<TermEntry>& pull = constraints[i].pull;
    Point middle(0, 0);
    for (const TermEntry& e : pull) middle += positions[static_cast<std::size_t>(e.node)];
    const double away = (middle / static_cast<double>(pull.size()) - place).norm();
    if (away < nearest) nearest = away, presses = constraints.is_closed(i);
  }
  return presses;
}

}  // namespace bempd::coupling

#pragma once

#include <vector>

#include "geometry/arrangement.hpp"
#include "geometry/edge_tree.hpp"

namespace bempd {

// Finds the hinges: points where several regions touch, not all of which are connected by contacts that pass through
// the point or end there. `boundaries[r]` has the edges of region r in the order to which the numbers in `contacts`
// refer.
std::vector<PointTouch> find_hinges(const std::vector<EdgeTree>& boundaries, const std::vector<Contact>& contacts,
                                    double tolerance);

}  // namespace bempd

#pragma once

#include <vector>

#include "geometry/arrangement.hpp"
#include "geometry/edge_tree.hpp"

namespace bempd {

// Points where the regions present are not all connected through contacts that pass or end there. `boundaries[r]` holds
// the edges of region r in their numbering, to which the contacts refer.
std::vector<PointTouch> find_hinges(const std::vector<EdgeTree>& boundaries, const std::vector<Contact>& contacts,
                                    double tolerance);

}  // namespace bempd

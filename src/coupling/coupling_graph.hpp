#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/terms.hpp"
#include "geometry/point.hpp"
#include "linalg/nested_dissection.hpp"

namespace bempd::coupling {

// Graph of the nodes that have common entries in the matrix of a system: the nodes of each energy term (bond or cell
// square; for tied nodes, their masters), and all nodes of each body.
linalg::NodeGraph coupling_graph(const std::vector<Point>& positions, const Terms& terms, const NodeTies& ties,
                                 const std::vector<std::vector<int>>& bodies);

}  // namespace bempd::coupling

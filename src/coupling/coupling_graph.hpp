#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/terms.hpp"
#include "geometry/point.hpp"
#include "linalg/nested_dissection.hpp"

namespace bempd::coupling {

// Which nodes have common entries in the matrix of a system: those of every term (of a tied node its masters) and all
// of a body.
linalg::NodeGraph coupling_graph(const std::vector<Point>& positions, const Terms& terms, const NodeTies& ties,
                                 const std::vector<std::vector<int>>& bodies);

}  // namespace bempd::coupling

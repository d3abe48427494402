#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"

namespace bempd::coupling {

// Bodies that cannot break, as lists of nodes: the nodes of each dense operator (or of each piece of a body that cracks
// have cut), and the nodes tied to them.
class DenseBodies {
 public:
  DenseBodies(int node_count, const std::vector<DenseOperator>& operators, const NodeTies& ties);

  const std::vector<std::vector<int>>& list() const { return list_; }
  bool contain(int node) const { return in_body_[node] != 0; }

 private:
  std::vector<std::vector<int>> list_;
  std::vector<char> in_body_;  // flag of each node
};

}  // namespace bempd::coupling

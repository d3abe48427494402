#include "coupling/coupling_graph.hpp"

namespace bempd::coupling {

linalg::NodeGraph coupling_graph(const std::vector<Point>& positions, const BondSet& bonds, const NodeTies& ties,
                                 const std::vector<std::vector<int>>& bodies) {
  const auto pulled = [&](int node) {
    std::vector<int> nodes;
    const int tie = ties.tie_of(node);
    if (tie < 0) return std::vector<int>{node};
    for (const NodeTies::Master& m : ties.masters(tie)) nodes.push_back(m.node);
    return nodes;
  };
  std::vector<int> first, second;
  first.reserve(bonds.size()), second.reserve(bonds.size());
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (ties.empty()) {
      first.push_back(bonds.first[b]), second.push_back(bonds.second[b]);
      continue;
    }
    for (int i : pulled(bonds.first[b])) {
      for (int j : pulled(bonds.second[b])) first.push_back(i), second.push_back(j);
    }
  }
  return {positions, first, second, bodies};
}

}  // namespace bempd::coupling

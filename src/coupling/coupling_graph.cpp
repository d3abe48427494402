#include "coupling/coupling_graph.hpp"

namespace bempd::coupling {

linalg::NodeGraph coupling_graph(const std::vector<Point>& positions, const Terms& terms, const NodeTies& ties,
                                 const std::vector<std::vector<int>>& bodies) {
  const auto pulled = [&](int node) {
    std::vector<int> nodes;
    const int tie = ties.tie_of(node);
    if (tie < 0) return std::vector<int>{node};
    for (const NodeTies::Master& m : ties.masters(tie)) nodes.push_back(m.node);
    return nodes;
  };
  std::vector<int> first, second;
  first.reserve(terms.size()), second.reserve(terms.size());
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (ties.empty() && !terms.is_wide(t)) {
      first.push_back(terms.first[t]), second.push_back(terms.second[t]);
      continue;
    }
    std::vector<std::vector<int>> pulled_by;
    terms.for_each_node(t, [&](int node) { pulled_by.push_back(pulled(node)); });
    for (std::size_t a = 0; a < pulled_by.size(); ++a) {
      for (std::size_t b = a + 1; b < pulled_by.size(); ++b) {
        for (int i : pulled_by[a]) {
          for (int j : pulled_by[b]) first.push_back(i), second.push_back(j);
        }
      }
    }
  }
  return {positions, first, second, bodies};
}

}  // namespace bempd::coupling

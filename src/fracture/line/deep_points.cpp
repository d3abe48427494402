#include "fracture/line/deep_points.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/adjacency.hpp"
#include "pd/bond_family.hpp"

namespace bempd::fracture {

namespace {

// Points deepest inside the lattices of one kind, whose points have the flag `is_of`: their own neighbours and, where
// such points exist, also neighbours and next neighbours have the largest number of neighbours. `full` is that number
// inside a lattice; points beside an outline that is oblique to the rows may have more neighbours, and do not count.
std::vector<int> deepest_of(const std::vector<char>& is_of, const linalg::Adjacency& neighbours, std::size_t full) {
  const auto is_own = [&](int node) { return is_of[static_cast<std::size_t>(node)] != 0; };
  std::size_t most = 0;
  const int nodes = static_cast<int>(is_of.size());
  for (int node = 0; node < nodes; ++node)
    if (is_own(node)) most = std::max(most, std::min(full, neighbours.of(node).size()));
  std::vector<char> depth(is_of.size(), 0);  // 1: full number of neighbours; 2: so have these; 3: and their neighbours
  for (int node = 0; node < nodes; ++node)
    depth[static_cast<std::size_t>(node)] = is_own(node) && neighbours.of(node).size() == most ? 1 : 0;
  for (const char level : {1, 2})
    for (int node = 0; node < nodes; ++node) {
      const auto is_deep = [&](int other) { return depth[static_cast<std::size_t>(other)] >= level; };
      if (is_deep(node) && std::ranges::all_of(neighbours.of(node), is_deep))
        depth[static_cast<std::size_t>(node)] = static_cast<char>(level + 1);
    }
  std::vector<int> found;
  const char deepest = depth.empty() ? char{0} : *std::ranges::max_element(depth);
  for (int node = 0; node < nodes; ++node)
    if (deepest > 0 && depth[static_cast<std::size_t>(node)] == deepest) found.push_back(node);
  return found;
}

}  // namespace

bool are_alike(const pd::TipLaw& one, const pd::TipLaw& other) {
  return one.spacing == other.spacing && one.horizon == other.horizon && one.thickness == other.thickness &&
         one.modulus == other.modulus;
}

std::vector<std::vector<int>> deep_points(const coupling::Terms& terms, const pd::TipLaws& laws) {
  const std::size_t nodes = laws.of_node.size();
  const linalg::Adjacency neighbours = linalg::make_adjacency(nodes, [&](const auto& add) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (terms.is_wide(t)) continue;
      add(terms.first[t], terms.second[t]);
      add(terms.second[t], terms.first[t]);
    }
  });
  std::vector<std::vector<int>> found(laws.laws.size());
  for (std::size_t law = 0; law < found.size(); ++law) {
    const auto alike = std::ranges::find_if(laws.laws, [&](const auto& l) { return are_alike(l, laws.laws[law]); });
    if (const auto first = static_cast<std::size_t>(alike - laws.laws.begin()); first < law) {
      found[law] = found[first];
      continue;
    }
    std::vector<char> is_of(nodes, 0);
    for (std::size_t node = 0; node < nodes; ++node)
      is_of[node] =
          laws.of_node[node] >= 0 && are_alike(laws.laws[static_cast<std::size_t>(laws.of_node[node])], laws.laws[law]);
    const double ratio = laws.laws[law].horizon / laws.laws[law].spacing;
    const std::size_t full = 2 * pd::bond_family(static_cast<int>(std::lround(ratio))).size();
    found[law] = deepest_of(is_of, neighbours, full);
  }
  return found;
}

}  // namespace bempd::fracture

#include "fracture/line/outline_points.hpp"

#include "fracture/line/whole_stiffness.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

namespace {

// Sum of the pulls of a point's bonds over the sum of their magnitudes, from which on the pulls do not balance.
constexpr double outline_pull = 0.1;

}  // namespace

// Finds points on the outline by their bonds: under constant stress these pull the point inwards, while the pulls at
// inner points balance. Weakened bonds count as whole, because the end of a crack is no outline.
OutlinePoints::OutlinePoints(const coupling::Terms& terms, const pd::TipLaws& laws, std::size_t nodes)
    : share_(nodes, 0) {
  std::vector<Point> pull(nodes, Point(0, 0));
  std::vector<double> sum(nodes, 0);
  const std::vector<double> stiffness = whole_stiffness(terms, laws.weakened);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms.is_wide(t)) continue;
    const double size = stiffness[t] * terms.length[t];
    const Point along = size * Point(terms.cosine[t], terms.sine[t]);
    const auto first = static_cast<std::size_t>(terms.first[t]), second = static_cast<std::size_t>(terms.second[t]);
    pull[first] += along, pull[second] -= along;
    sum[first] += size, sum[second] += size;
  }
  for (std::size_t node = 0; node < nodes; ++node) {
    if (!(pull[node].norm() > outline_pull * sum[node])) continue;
    const double known = node < laws.share_of_node.size() ? laws.share_of_node[node] : 0;
    share_[node] = known > 0 ? known : 0.5;
  }
}

}  // namespace bempd::fracture

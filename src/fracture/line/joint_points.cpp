#include "fracture/line/joint_points.hpp"

namespace bempd::fracture {

namespace {

// Distance from a border with boundary elements, in spacings, within which material points are left out of the fit of
// stresses. Tips two horizons before the border get critical loads within 0.9 % without such points, and up to 2.2 %
// off with them (docs/mixed_cracks.md).
constexpr double beside_border = 2.2;

}  // namespace

JointPoints::JointPoints(const std::vector<Point>& positions, const NearPoints& near, const pd::TipLaws& laws)
    : beside_(positions.size(), 0) {
  for (std::size_t n = 0; n < laws.joined.size(); ++n) {
    if (!laws.is_joined(static_cast<int>(n)) || laws.of_node[n] < 0) continue;
    const double reach = beside_border * laws.laws[static_cast<std::size_t>(laws.of_node[n])].spacing;
    for (const int node : near.about(positions[n], reach)) {
      const auto other = static_cast<std::size_t>(node);
      if ((positions[other] - positions[n]).norm() < reach) beside_[other] = 1;
    }
  }
}

}  // namespace bempd::fracture

#include "fracture/interface_bonds.hpp"

#include <algorithm>
#include <limits>

namespace bempd::fracture {

namespace {

// Ratio of the length of a bond to that of the shortest bond at a node, up to which the bond counts as one of the
// shortest.
constexpr double shortest = 1.01;

}  // namespace

InterfaceBonds::InterfaceBonds(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions)
    : system_(system) {
  const coupling::Terms& terms = system.terms();
  std::vector<double> least(positions.size(), std::numeric_limits<double>::infinity());
  const auto at_body = [&](const auto& visit) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const int first = terms.first[t], second = terms.second[t];
      if (terms.is_wide(t)) continue;
      if (!system.dense_bodies().contain(first) && !system.dense_bodies().contain(second)) continue;
      const double length = (positions[second] - positions[first]).norm();
      for (int node : {first, second}) {
        if (system.dense_bodies().contain(node)) visit(static_cast<int>(t), node, length);
      }
    }
  };
  at_body([&](int, int node, double length) { least[node] = std::min(least[node], length); });
  at_body([&](int term, int node, double length) {
    if (system.stages().intact()[term] && length <= shortest * least[node]) bonds_.push_back({term, node});
  });
}

std::optional<int> InterfaceBonds::reached() const {
  const auto is_broken = [&](const Bond& bond) { return !system_.stages().intact()[bond.term]; };
  const auto found = std::find_if(bonds_.begin(), bonds_.end(), is_broken);
  return found == bonds_.end() ? std::nullopt : std::optional(found->node);
}

}  // namespace bempd::fracture

#include "regions/node_registry.hpp"

#include <cmath>

namespace bempd::regions {

std::size_t NodeRegistry::CellHash::operator()(const Cell& cell) const {
  return std::hash<std::int64_t>()(cell.first * 1000003 + cell.second);
}

NodeRegistry::Cell NodeRegistry::cell_of(const Point& position) const {
  const Point scaled = (position - origin_) / (4 * tolerance_);
  return {static_cast<std::int64_t>(std::floor(scaled.x())), static_cast<std::int64_t>(std::floor(scaled.y()))};
}

int NodeRegistry::add(const Point& position) {
  positions_.push_back(position);
  return static_cast<int>(positions_.size()) - 1;
}

int NodeRegistry::add_shared(const Point& position, int region, int side) {
  const Cell centre = cell_of(position);
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      const auto found = cells_.find({centre.first + dx, centre.second + dy});
      if (found == cells_.end()) continue;
      for (Entry& entry : found->second) {
        // Nodes of the same region are never merged, however close they are, because they may be the two faces of a
        // crack.
        if (entry.last_region == region || entry.side != side) continue;
        if ((positions_[entry.node] - position).norm() > tolerance_) continue;
        entry.last_region = region;
        return entry.node;
      }
    }
  }
  const int node = add(position);
  cells_[centre].push_back({node, region, side});
  return node;
}

}  // namespace bempd::regions

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "geometry/boundary_mesh.hpp"
#include "geometry/edge.hpp"

namespace bempd {

// Nodes found by their places, which may differ by rounding. The tolerance is less than the geometric tolerance,
// because graded elements can be shorter than that.
class PlacedNodes {
 public:
  explicit PlacedNodes(const BoundaryMesh& body) {
    Box box;
    for (const Point& place : body.nodes) box.extend(place);
    const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    cell_ = std::max(1e-12 * box.diagonal().norm(), 4 * std::numeric_limits<double>::epsilon() * largest);
    origin_ = box.min();
    nodes_.reserve(body.elements.size());
    for (const BoundaryElement& element : body.elements) add(body.nodes[element.nodes[0]], element.nodes[0]);
  }
  void add(const Point& place, int node) { nodes_[cell_of(place)] = node; }
  int at(const Point& place) const {  // -1: no node there
    const auto [column, row] = cell_of(place);
    for (const std::int64_t i : {0, -1, 1})
      for (const std::int64_t j : {0, -1, 1})
        if (const auto found = nodes_.find({column + i, row + j}); found != nodes_.end()) return found->second;
    return -1;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  Cell cell_of(const Point& place) const {
    const Point off = (place - origin_) / cell_;
    return {std::llround(off.x()), std::llround(off.y())};
  }

  struct HashOfCell {
    std::size_t operator()(const Cell& cell) const {
      constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
      const std::uint64_t mixed =
          (static_cast<std::uint64_t>(cell.first) * odd) ^ static_cast<std::uint64_t>(cell.second);
      return static_cast<std::size_t>((mixed * odd) >> 16U);
    }
  };

  double cell_;
  Point origin_;
  std::unordered_map<Cell, int, HashOfCell> nodes_;
};

}  // namespace bempd

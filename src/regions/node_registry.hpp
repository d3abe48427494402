#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::regions {

// Numbers the nodes of all regions. Nodes of different regions that lie at the same place on an interface become one
// node.
class NodeRegistry {
 public:
  NodeRegistry(const Point& origin, double tolerance) : origin_(origin), tolerance_(tolerance) {}

  // Adds a node that belongs to one region only, and returns its number.
  int add(const Point& position);

  // Returns the number of a node on an interface: the node that another region has added at this place, or a new one.
  // Where a crack crosses the interface, each face of the crack has a node of its own: `side` is 1 on the crack's left,
  // -1 on its right, 0 for all other nodes.
  int add_shared(const Point& position, int region, int side = 0);

  const std::vector<Point>& positions() const { return positions_; }

 private:
  struct Entry {
    int node;
    int last_region;
    int side;
  };
  using Cell = std::pair<std::int64_t, std::int64_t>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  Cell cell_of(const Point& position) const;

  Point origin_;
  double tolerance_;
  std::vector<Point> positions_;
  std::unordered_map<Cell, std::vector<Entry>, CellHash> cells_;
};

}  // namespace bempd::regions

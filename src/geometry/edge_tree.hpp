#pragma once

#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/outline.hpp"

namespace bempd {

// Edges of a body with a tree that finds them by place.
struct EdgeTree {
  explicit EdgeTree(std::vector<Edge> all);

  // Whether an edge comes as close to the point as the tolerance.
  bool passes(const Point& p, double tolerance) const;
  // Location of a point as locate() of all edges finds it, faster.
  Location locate(const Point& p, double tolerance) const;

  std::vector<Edge> edges;
  BoxTree tree;
  Box box;
};

}  // namespace bempd

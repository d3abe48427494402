#pragma once

#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/outline.hpp"

namespace bempd {

// The edges of a body, found by place.
struct EdgeTree {
  explicit EdgeTree(std::vector<Edge> all);

  // Whether an edge comes as close to the point as the tolerance.
  bool passes(const Point& p, double tolerance) const;
  // As the function of the same name for all edges.
  Location locate(const Point& p, double tolerance) const;

  std::vector<Edge> edges;
  BoxTree tree;
  Box box;
};

}  // namespace bempd

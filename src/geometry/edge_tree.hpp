#pragma once

#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/outline.hpp"

namespace bempd {

// Edges of a body with a tree to find the edges near a place.
struct EdgeTree {
  explicit EdgeTree(std::vector<Edge> all);

  // Whether an edge comes as close to the point as `tolerance`.
  bool passes(const Point& p, double tolerance) const;
  // Location of a point: the result of locate() for all edges, but faster.
  Location locate(const Point& p, double tolerance) const;

  std::vector<Edge> edges;
  BoxTree tree;
  Box box;
};

}  // namespace bempd

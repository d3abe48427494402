#include "geometry/edge_tree.hpp"

#include <utility>

namespace bempd {

EdgeTree::EdgeTree(std::vector<Edge> all) : edges(std::move(all)) {
  std::vector<Box> boxes;
  for (const Edge& edge : edges) {
    boxes.push_back(bounding_box(edge));
    box.extend(boxes.back());
  }
  tree = BoxTree(boxes);
}

bool EdgeTree::passes(const Point& p, double tolerance) const {
  // A margin is needed because the boxes of arcs are rounded.
  const Point margin = Point::Constant(2 * tolerance);
  const Box around(p - margin, p + margin);
  return tree.any([&](const Box& other) { return other.intersects(around); },
                  [&](int k) { return distance(edges[k], p) <= tolerance; });
}

Location EdgeTree::locate(const Point& p, double tolerance) const {
  if (passes(p, tolerance)) return Location::on_boundary;
  bool inside = false;
  const auto beside = [&](const Box& other) {
    return other.max().x() >= p.x() && other.min().y() <= p.y() && other.max().y() >= p.y();
  };
  tree.any(beside, [&](int k) {
    if (ray_crosses(edges[k], p)) inside = !inside;
    return false;
  });
  return inside ? Location::inside : Location::outside;
}

}  // namespace bempd

#pragma once

#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Tree of the bounding boxes of many items, with which the items near a place or box are found. Each node of the tree
// is halved along its longer side.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  // Calls visit(number), in any order, for the items for which is_near(box) is true for their own box and all boxes of
  // the tree around it, until visit() returns true. Returns whether visit() has returned true.
  template <class IsNear, class Visit>
  bool any(const IsNear& is_near, const Visit& visit) const {
    for (std::size_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      if (!is_near(node.box)) {
        n = node.next;
        continue;
      }
      for (int i = node.begin; i < node.end; ++i)
        if (is_near(boxes_[i]) && visit(items_[i])) return true;
      ++n;
    }
    return false;
  }

  // Numbers of the items whose boxes meet the given box, ascending.
  std::vector<int> meeting(const Box& box) const;

 private:
  struct Node {
    Box box;
    int begin, end;    // range of its items; empty except in leaves
    std::size_t next;  // first node that is not below this node
  };
  void add(const std::vector<Box>& boxes, int begin, int end);

  std::vector<Node> nodes_;  // every node comes before the nodes below it
  std::vector<int> items_;
  std::vector<Box> boxes_;  // boxes of `items_`
};

}  // namespace bempd

#pragma once

#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Tree of bounding boxes, halved along their longer side, to find those of many items that lie near something.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  // Calls visit(number) for the items whose boxes, and all boxes around these, satisfy is_near(box), in any order,
  // until it returns true. Returns whether it did.
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
    int begin, end;    // its own things; none but in leaves
    std::size_t next;  // the first node that is not below this one
  };
  void add(const std::vector<Box>& boxes, int begin, int end);

  std::vector<Node> nodes_;  // every node before those below it
  std::vector<int> items_;
  std::vector<Box> boxes_;  // of the items
};

}  // namespace bempd

#include "geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace bempd {

BoxTree::BoxTree(const std::vector<Box>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (!boxes.empty()) add(boxes, 0, static_cast<int>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (const int item : items_) boxes_.push_back(boxes[item]);
}

void BoxTree::add(const std::vector<Box>& boxes, int begin, int end) {
  constexpr int largest_leaf = 8;
  const std::size_t own = nodes_.size();
  const bool leaf = end - begin <= largest_leaf;
  nodes_.push_back({Box(), begin, leaf ? end : begin, 0});
  for (int i = begin; i < end; ++i) nodes_[own].box.extend(boxes[items_[i]]);
  if (!leaf) {
    const Point size = nodes_[own].box.sizes();
    const int axis = size.x() >= size.y() ? 0 : 1, middle = begin + (end - begin) / 2;
    const auto lower = [&](int a, int b) {
      return boxes[a].min()[axis] + boxes[a].max()[axis] < boxes[b].min()[axis] + boxes[b].max()[axis];
    };
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end, lower);
    add(boxes, begin, middle);
    add(boxes, middle, end);
  }
  nodes_[own].next = nodes_.size();
}

std::vector<int> BoxTree::meeting(const Box& box) const {
  std::vector<int> found;
  any([&](const Box& other) { return other.intersects(box); },
      [&](int item) {
        found.push_back(item);
        return false;
      });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace bempd

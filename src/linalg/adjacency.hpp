#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace bempd::linalg {

// Lists of integers, one list per item, stored in one array.
struct Adjacency {
  std::vector<int> offset{0};
  std::vector<int> value;

  std::span<const int> of(int item) const {
    return {value.data() + offset[item], static_cast<std::size_t>(offset[item + 1] - offset[item])};
  }
  std::span<int> of(int item) {
    return {value.data() + offset[item], static_cast<std::size_t>(offset[item + 1] - offset[item])};
  }
};

// Makes the lists of `items` items. each(add) must call add(item, value) for every entry. It is called twice and must
// give the entries in the same order both times. A list keeps the order of its entries.
template <class Each>
Adjacency make_adjacency(std::size_t items, const Each& each) {
  Adjacency lists;
  lists.offset.assign(items + 1, 0);
  each([&](int item, int) { ++lists.offset[item + 1]; });
  std::partial_sum(lists.offset.begin(), lists.offset.end(), lists.offset.begin());
  lists.value.resize(static_cast<std::size_t>(lists.offset.back()));
  std::vector<int> next(lists.offset.begin(), lists.offset.end() - 1);
  each([&](int item, int value) { lists.value[next[item]++] = value; });
  return lists;
}

}  // namespace bempd::linalg

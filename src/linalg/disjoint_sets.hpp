#pragma once

#include <numeric>
#include <vector>

namespace bempd::linalg {

// Disjoint sets of the numbers 0 .. count - 1, which can be joined two at a time (Tarjan 1975, with path halving).
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // Smallest member of the set that contains `member`; this number identifies the set.
  int find(int member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(int member, int other) {
    member = find(member);
    other = find(other);
    if (member < other) {
      parent_[other] = member;
    } else {
      parent_[member] = other;
    }
  }

 private:
  std::vector<int> parent_;
};

}  // namespace bempd::linalg

#pragma once

#include <numeric>
#include <vector>

namespace bempd::linalg {

// Disjoint sets of the numbers 0 .. count - 1, joined two at a time (Tarjan 1975; paths are halved).
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // Smallest member of the set that has this member: the name of the set.
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

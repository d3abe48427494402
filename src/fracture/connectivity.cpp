#include "fracture/connectivity.hpp"

#include <algorithm>
#include <numeric>

namespace bempd::fracture {

namespace {

class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The smaller root wins, so a set's root is its first member.
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

Connectivity::Connectivity(const coupling::EquilibriumSystem& system)
    : system_(system), offset_(system.node_count() + 1, 0), bond_at_(2 * system.bonds().size()) {
  const coupling::BondSet& bonds = system.bonds();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    ++offset_[bonds.first[b] + 1];
    ++offset_[bonds.second[b] + 1];
  }
  std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
  std::vector<int> next(offset_.begin(), offset_.end() - 1);
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    bond_at_[next[bonds.first[b]]++] = static_cast<int>(b);
    bond_at_[next[bonds.second[b]]++] = static_cast<int>(b);
  }
}

std::vector<std::vector<int>> Connectivity::pieces() const {
  DisjointSets sets(system_.node_count());
  const coupling::BondSet& bonds = system_.bonds();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (system_.intact()[b]) sets.join(bonds.first[b], bonds.second[b]);
  }
  for (const auto& body : system_.dense_bodies()) {
    for (int node : body) sets.join(body.front(), node);
  }
  std::vector<int> index(system_.node_count(), -1);
  std::vector<std::vector<int>> result;
  for (int node = 0; node < system_.node_count(); ++node) {
    const int root = sets.find(node);
    if (index[root] < 0) {
      index[root] = static_cast<int>(result.size());
      result.emplace_back();
    }
    result[index[root]].push_back(node);
  }
  return result;
}

bool Connectivity::are_joined(int node, int other) const {
  const coupling::BondSet& bonds = system_.bonds();
  visited_.resize(system_.node_count(), 0);
  ++search_;
  std::vector<int> open{node};
  visited_[node] = search_;
  std::vector<char> body_seen(system_.dense_bodies().size(), 0);
  const auto visit = [&](int next) {
    if (visited_[next] == search_) return;
    visited_[next] = search_;
    open.push_back(next);
  };
  for (std::size_t k = 0; k < open.size(); ++k) {
    const int at = open[k];
    if (at == other) return true;
    for (int i = offset_[at]; i < offset_[at + 1]; ++i) {
      const int b = bond_at_[i];
      if (system_.intact()[b]) visit(bonds.first[b] == at ? bonds.second[b] : bonds.first[b]);
    }
    if (!system_.in_dense_body(at)) continue;
    for (std::size_t body = 0; body < body_seen.size(); ++body) {
      const std::vector<int>& nodes = system_.dense_bodies()[body];
      if (body_seen[body] || std::find(nodes.begin(), nodes.end(), at) == nodes.end()) continue;
      body_seen[body] = 1;
      for (int n : nodes) visit(n);
    }
  }
  return false;
}

std::vector<int> Connectivity::intact_bonds_at(int node) const {
  std::vector<int> result;
  for (int k = offset_[node]; k < offset_[node + 1]; ++k) {
    if (system_.intact()[bond_at_[k]]) result.push_back(bond_at_[k]);
  }
  return result;
}

bool Connectivity::still_joined(const std::vector<int>& removed_bonds) const {
  const coupling::BondSet& bonds = system_.bonds();
  const auto neighbours = [&](int node) {
    std::vector<int> result;
    for (int b : intact_bonds_at(node)) result.push_back(bonds.first[b] == node ? bonds.second[b] : bonds.first[b]);
    return result;
  };
  for (int b : removed_bonds) {
    const std::vector<int> left = neighbours(bonds.first[b]);
    bool joined = false;
    for (int node : neighbours(bonds.second[b])) {
      for (int other : left) joined = joined || other == node;
    }
    if (!joined) return false;
  }
  return true;
}

}  // namespace bempd::fracture

#include "fracture/connectivity.hpp"

#include <algorithm>

#include "linalg/disjoint_sets.hpp"

namespace bempd::fracture {

Connectivity::Connectivity(const coupling::EquilibriumSystem& system)
    : system_(system), terms_at_(linalg::make_adjacency(system.node_count(), [&](const auto& add) {
        for (std::size_t t = 0; t < system.terms().size(); ++t) {
          system.terms().for_each_node(t, [&](int node) { add(node, static_cast<int>(t)); });
        }
      })) {}

std::vector<std::vector<int>> Connectivity::pieces() const {
  linalg::DisjointSets sets(system_.node_count());
  const coupling::Terms& terms = system_.terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (system_.stages().intact()[t]) sets.join(terms.first[t], terms.second[t]);
  }
  for (int t : terms.wide.term) {
    const auto term = static_cast<std::size_t>(t);
    if (system_.stages().intact()[term])
      terms.for_each_node(term, [&](int node) { sets.join(terms.first[term], node); });
  }
  for (const auto& body : system_.dense_bodies().list()) {
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
  visited_.resize(system_.node_count(), 0);
  ++search_;
  std::vector<int> open{node};
  visited_[node] = search_;
  std::vector<char> body_seen(system_.dense_bodies().list().size(), 0);
  const auto visit = [&](int next) {
    if (visited_[next] == search_) return;
    visited_[next] = search_;
    open.push_back(next);
  };
  for (std::size_t k = 0; k < open.size(); ++k) {
    const int at = open[k];
    if (at == other) return true;
    for (int t : terms_at_.of(at)) {
      if (system_.stages().intact()[t]) system_.terms().for_each_node(static_cast<std::size_t>(t), visit);
    }
    if (!system_.dense_bodies().contain(at)) continue;
    for (std::size_t body = 0; body < body_seen.size(); ++body) {
      const std::vector<int>& nodes = system_.dense_bodies().list()[body];
      if (body_seen[body] || std::find(nodes.begin(), nodes.end(), at) == nodes.end()) continue;
      body_seen[body] = 1;
      for (int n : nodes) visit(n);
    }
  }
  return false;
}

std::vector<int> Connectivity::intact_terms_at(int node) const {
  std::vector<int> result;
  for (int t : terms_at_.of(node)) {
    if (system_.stages().intact()[t]) result.push_back(t);
  }
  return result;
}

bool Connectivity::still_joined(const std::vector<int>& removed) const {
  const coupling::Terms& terms = system_.terms();
  const auto neighbours = [&](int node) {
    std::vector<int> result;
    for (int t : intact_terms_at(node)) {
      terms.for_each_node(static_cast<std::size_t>(t), [&](int other) {
        if (other != node) result.push_back(other);
      });
    }
    return result;
  };
  const auto are_close = [&](int node, int other) {
    const std::vector<int> left = neighbours(node), right = neighbours(other);
    return std::any_of(right.begin(), right.end(),
                       [&](int n) { return std::find(left.begin(), left.end(), n) != left.end(); });
  };
  for (int t : removed) {
    bool joined = true;
    terms.for_each_node(static_cast<std::size_t>(t), [&](int node) {
      if (node != terms.first[t]) joined = joined && are_close(terms.first[t], node);
    });
    if (!joined) return false;
  }
  return true;
}

}  // namespace bempd::fracture

#pragma once

#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

// Connectivity of nodes by intact terms (bonds and cell squares), and by bodies that cannot break (boundary element
// regions).
class Connectivity {
 public:
  explicit Connectivity(const coupling::EquilibriumSystem& system);

  // Connected pieces of the body: lists of nodes, each in ascending order, in the order of their first nodes.
  std::vector<std::vector<int>> pieces() const;

  // Whether the connected pieces of the body certainly stay the same without the terms `removed`, because the nodes of
  // each of these terms share an intact neighbour. False means that the pieces may differ.
  bool still_joined(const std::vector<int>& removed) const;

  // Whether a path of intact terms and bodies that cannot break leads from one node to the other.
  bool are_joined(int node, int other) const;

  std::vector<int> intact_terms_at(int node) const;

 private:
  const coupling::EquilibriumSystem& system_;
  mutable std::vector<int> visited_;  // number of the last search that visited each node
  mutable int search_ = 0;
  linalg::Adjacency terms_at_;  // terms at every node
};

}  // namespace bempd::fracture

#pragma once

#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

// Connectivity of nodes by intact terms and by bodies that cannot break (boundary element regions).
class Connectivity {
 public:
  explicit Connectivity(const coupling::EquilibriumSystem& system);

  // Pieces of the body: lists of nodes, each in ascending order, in the order of their first nodes.
  std::vector<std::vector<int>> pieces() const;

  // Whether all nodes of each term share an intact neighbour, so that the pieces are the same without these terms.
  // False means: unknown.
  bool still_joined(const std::vector<int>& removed) const;

  // Whether a path of intact terms and bodies that cannot break leads from one node to the other.
  bool are_joined(int node, int other) const;

  std::vector<int> intact_terms_at(int node) const;

 private:
  const coupling::EquilibriumSystem& system_;
  mutable std::vector<int> visited_;  // per node: the search that came by last
  mutable int search_ = 0;
  linalg::Adjacency terms_at_;  // of every node
};

}  // namespace bempd::fracture

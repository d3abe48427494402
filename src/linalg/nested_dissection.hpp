#pragma once

#include <Eigen/Core>
#include <vector>

#include "linalg/adjacency.hpp"

namespace bempd::linalg {

// Graph of the couplings of a matrix between nodes in the plane: pairs of coupled nodes (partners), and groups of nodes
// that are all coupled to each other.
struct NodeGraph {
  std::vector<Eigen::Vector2d> positions;
  Adjacency partners;
  std::vector<std::vector<int>> groups;

  NodeGraph() = default;
  NodeGraph(std::vector<Eigen::Vector2d> positions_of_nodes, const std::vector<int>& first,
            const std::vector<int>& second, std::vector<std::vector<int>> coupled_groups);
};

// Order of elimination with little fill (George 1973). The nodes are divided into two halves across their longer
// extent; the nodes that couple the two halves come last, and each half is ordered in the same way. Only nodes with the
// flag 1 in `member` are ordered.
std::vector<int> nested_dissection(const NodeGraph& graph, const std::vector<char>& member);

}  // namespace bempd::linalg

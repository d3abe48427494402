#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "linalg/adjacency.hpp"

namespace bempd::linalg {

// Graph of the couplings of a matrix between nodes in the plane: pairs of coupled nodes (partners), and groups in which
// all nodes are coupled to each other.
struct NodeGraph {
  std::vector<Eigen::Vector2d> positions;
  Adjacency partners;
  std::vector<std::vector<int>> groups;

  NodeGraph() = default;
  NodeGraph(std::vector<Eigen::Vector2d> positions_of_nodes, const std::vector<int>& first,
            const std::vector<int>& second, std::vector<std::vector<int>> coupled_groups);
};

// Order of elimination with little fill (George 1973): the nodes are halved across their longer side, and the nodes
// that couple the two halves come after both. The halves are ordered in the same way. Only nodes marked in `member` are
// ordered.
std::vector<int> nested_dissection(const NodeGraph& graph, const std::vector<char>& member);

}  // namespace bempd::linalg

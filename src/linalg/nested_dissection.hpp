#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "linalg/adjacency.hpp"

namespace bempd::linalg {

// Graph of the couplings of a matrix: pairs of nodes, each at most `reach` apart from its partners, and groups all of
// whose members are coupled to each other.
struct NodeGraph {
  std::vector<Eigen::Vector2d> positions;
  Adjacency partners;
  std::vector<std::vector<int>> groups;

  NodeGraph() = default;
  NodeGraph(std::vector<Eigen::Vector2d> positions_of_nodes, const std::vector<int>& first,
            const std::vector<int>& second, std::vector<std::vector<int>> coupled_groups);
};

// Order of elimination with little fill (George 1973): the nodes are halved across their longer side, the nodes that
// couple the halves come after both, and the halves are ordered in the same way. Only nodes marked in `member` are
// ordered.
std::vector<int> nested_dissection(const NodeGraph& graph, const std::vector<char>& member);

}  // namespace bempd::linalg

#pragma once

#include <Eigen/Core>
#include <vector>

namespace bempd::coupling {

// Tied nodes, whose displacements are weighted sums of the displacements of other nodes, their masters. Lattice points
// on an interface are tied to the nodes of the boundary elements there. A force on a tied node acts on the masters with
// the same weights, so that no work is lost. Masters are not tied themselves.
class NodeTies {
 public:
  struct Master {
    int node;
    double weight;
  };

  void add(int node, std::vector<Master> masters);

  bool empty() const { return nodes_.empty(); }
  const std::vector<int>& nodes() const { return nodes_; }
  const std::vector<Master>& masters(std::size_t tie) const { return masters_[tie]; }

  // Index of the tie by which a node follows its masters; -1 if the node is not tied.
  int tie_of(int node) const {
    return node < static_cast<int>(tie_of_.size()) ? tie_of_[static_cast<std::size_t>(node)] : -1;
  }

  // Sets the displacements of tied nodes from those of their masters.
  void expand(Eigen::Ref<Eigen::MatrixXd> displacement) const;
  void expand_rows(Eigen::Ref<Eigen::MatrixXd> displacements) const;  // one state per row

  // Moves forces on tied nodes to their masters.
  void collect(Eigen::Ref<Eigen::MatrixXd> force) const;

 private:
  std::vector<int> nodes_;
  std::vector<std::vector<Master>> masters_;  // masters of each tie
  std::vector<int> tie_of_;                   // tie of each node, or -1
};

}  // namespace bempd::coupling

#include "coupling/node_ties.hpp"

#include <cassert>

namespace bempd::coupling {

void NodeTies::add(int node, std::vector<Master> masters) {
  assert(tie_of(node) < 0);
  if (static_cast<int>(tie_of_.size()) <= node) tie_of_.resize(static_cast<std::size_t>(node) + 1, -1);
  tie_of_[static_cast<std::size_t>(node)] = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  masters_.push_back(std::move(masters));
}

void NodeTies::expand(Eigen::Ref<Eigen::MatrixXd> displacement) const {
  for (std::size_t t = 0; t < nodes_.size(); ++t) {
    auto tied = displacement.middleRows<2>(2 * nodes_[t]);
    tied.setZero();
    for (const Master& m : masters_[t]) tied += m.weight * displacement.middleRows<2>(2 * m.node);
  }
}

void NodeTies::expand_rows(Eigen::Ref<Eigen::MatrixXd> displacements) const {
  for (std::size_t t = 0; t < nodes_.size(); ++t) {
    auto tied = displacements.middleCols<2>(2 * nodes_[t]);
    tied.setZero();
    for (const Master& m : masters_[t]) tied += m.weight * displacements.middleCols<2>(2 * m.node);
  }
}

void NodeTies::collect(Eigen::Ref<Eigen::MatrixXd> force) const {
  for (std::size_t t = 0; t < nodes_.size(); ++t) {
    auto tied = force.middleRows<2>(2 * nodes_[t]);
    for (const Master& m : masters_[t]) force.middleRows<2>(2 * m.node) += m.weight * tied;
    tied.setZero();
  }
}

}  // namespace bempd::coupling

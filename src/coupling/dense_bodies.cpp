#include "coupling/dense_bodies.hpp"

namespace bempd::coupling {

DenseBodies::DenseBodies(int node_count, const std::vector<DenseOperator>& operators, const NodeTies& ties)
    : in_body_(node_count, 0) {
  std::vector<int> body_of(node_count, -1);
  for (const DenseOperator& op : operators) {
    const auto add = [&](const std::vector<int>& nodes) {
      for (int node : nodes) body_of[node] = static_cast<int>(list_.size());
      list_.push_back(nodes);
    };
    if (op.pieces.empty()) add(op.nodes);
    for (const BodyPiece& piece : op.pieces) add(piece.nodes);
  }
  for (std::size_t t = 0; t < ties.nodes().size(); ++t) {
    list_[body_of[ties.masters(t).front().node]].push_back(ties.nodes()[t]);
  }
  for (const std::vector<int>& body : list_) {
    for (int node : body) in_body_[node] = 1;
  }
}

}  // namespace bempd::coupling

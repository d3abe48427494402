#include "coupling/unknowns.hpp"

namespace bempd::coupling {

Unknowns classify(int node_count, const std::vector<DenseOperator>& operators, const Terms& terms, const NodeTies& ties,
                  const std::vector<char>& prescribed) {
  std::vector<int> operators_at(node_count, 0);
  std::vector<char> has_term(node_count, 0), held(node_count, 0);
  for (std::size_t t = 0; t < terms.size(); ++t) has_term[terms.first[t]] = has_term[terms.second[t]] = 1;
  for (const TermEntry& e : terms.wide.entry) has_term[e.node] = 1;
  for (const DenseOperator& op : operators) {
    for (int node : op.nodes) ++operators_at[node];
    for (const BodyPiece& piece : op.pieces)
      for (int node : piece.holdable) held[node] = 1;
  }
  // A tied node passes the forces of its terms on to its masters.
  for (std::size_t t = 0; t < ties.nodes().size(); ++t) {
    for (const NodeTies::Master& m : ties.masters(t)) has_term[m.node] = 1;
  }
  Unknowns unknowns;
  unknowns.kind.resize(2 * node_count);
  unknowns.unknown_of.assign(2 * node_count, -1);
  for (int node = 0; node < node_count; ++node) {
    const bool shared = has_term[node] || held[node] || operators_at[node] != 1;
    const bool tied = ties.tie_of(node) >= 0;
    for (int dof = 2 * node; dof < 2 * node + 2; ++dof) {
      unknowns.kind[dof] = tied              ? DofKind::tied
                           : prescribed[dof] ? DofKind::prescribed
                           : shared          ? DofKind::shared_free
                                             : DofKind::private_free;
      if (unknowns.kind[dof] != DofKind::shared_free) continue;
      unknowns.unknown_of[dof] = static_cast<int>(unknowns.dof_of.size());
      unknowns.dof_of.push_back(dof);
    }
  }
  return unknowns;
}

}  // namespace bempd::coupling

#include "bem/kept_blocks.hpp"

#include <algorithm>

namespace bempd::bem {

namespace {

// Whether two elements are equal up to the rounding errors of positions that were computed in different ways.
bool alike(const GalerkinElement& a, const GalerkinElement& b) {
  if (a.crack != b.crack || a.geometry.tip != b.geometry.tip) return false;
  const double slack = 1e-12 * a.geometry.c1.norm() + 1e-15;
  const auto coincide = [&](const Point& p, const Point& q) { return (p - q).lpNorm<Eigen::Infinity>() <= slack; };
  return coincide(a.geometry.at(-1), b.geometry.at(-1)) && coincide(a.geometry.at(0), b.geometry.at(0)) &&
         coincide(a.geometry.at(1), b.geometry.at(1));
}

// Numbers in the list `before` of the elements that equal those of `elements`, in the order of the latter; -1 where no
// element is equal. Both lists have similar orders, which makes the search fast.
std::vector<int> same_elements(const std::vector<GalerkinElement>& before,
                               const std::vector<GalerkinElement>& elements) {
  const int count = static_cast<int>(before.size());
  std::vector<int> same;
  int guess = 0;
  for (const GalerkinElement& element : elements) {
    same.push_back(-1);
    for (int tried = 0; tried < count && same.back() < 0; ++tried) {
      const int candidate = (guess + tried) % count;
      if (!alike(before[candidate], element)) continue;
      same.back() = candidate;
      guess = candidate + 1;
    }
  }
  return same;
}

// Number in the earlier body of every node whose elements are all the same in both bodies; -1 for other nodes.
// `nodes_of` returns the nodes of an element, -1 for none; `same` is the result of same_elements().
template <class NodesOf>
std::vector<int> nodes_of_same(const std::vector<GalerkinElement>& before, const std::vector<GalerkinElement>& elements,
                               const std::vector<int>& same, int count, const NodesOf& nodes_of) {
  constexpr int unknown = -2;
  std::vector<int> kept(count, unknown), uses(count, 0);
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int node = nodes_of(elements[e])[k];
      if (node < 0) continue;
      const int other = same[e] < 0 ? -1 : nodes_of(before[same[e]])[k];
      kept[node] = kept[node] == unknown || kept[node] == other ? other : -1;
      ++uses[node];
    }
  std::vector<int> uses_before;
  for (const GalerkinElement& e : before)
    for (const int node : nodes_of(e)) {
      if (node >= static_cast<int>(uses_before.size())) uses_before.resize(node + 1, 0);
      if (node >= 0) ++uses_before[node];
    }
  for (int n = 0; n < count; ++n)
    if (kept[n] < 0 || uses[n] != uses_before[kept[n]]) kept[n] = -1;
  return kept;
}

// Number of the body's piece on which each node (or traction node) lies.
std::vector<int> pieces_of_nodes(const std::vector<GalerkinElement>& elements, int count, bool tractions) {
  std::vector<int> pieces(count, 0);
  for (const GalerkinElement& e : elements)
    for (const int node : tractions ? e.traction_nodes : e.nodes)
      if (node >= 0) pieces[node] = e.piece;
  return pieces;
}

bool is_whole_boundary(const std::vector<GalerkinElement>& before, const std::vector<GalerkinElement>& elements,
                       const std::vector<int>& same) {
  std::size_t boundary = 0;
  for (; boundary < elements.size() && !elements[boundary].crack; ++boundary)
    if (same[boundary] != static_cast<int>(boundary) ||
        before[boundary].traction_nodes != elements[boundary].traction_nodes ||
        before[boundary].piece != elements[boundary].piece)
      return false;
  return boundary == before.size() || before[boundary].crack;
}

}  // namespace

bool KeptNodes::has(const GalerkinElement& element) const {
  const auto is_kept = [](const std::vector<int>& kept, const std::array<int, 3>& of_element) {
    return std::all_of(of_element.begin(), of_element.end(), [&](int node) { return node < 0 || kept[node] >= 0; });
  };
  return is_kept(nodes, element.nodes) && is_kept(traction_nodes, element.traction_nodes);
}

KeptNodes kept_nodes(const std::vector<GalerkinElement>& before, const std::vector<GalerkinElement>& elements,
                     int boundary_nodes, int nodes, int traction_nodes) {
  const std::vector<int> same = same_elements(before, elements);
  return {
      nodes_of_same(before, elements, same, nodes, [](const GalerkinElement& e) { return e.nodes; }),
      nodes_of_same(before, elements, same, traction_nodes, [](const GalerkinElement& e) { return e.traction_nodes; }),
      is_whole_boundary(before, elements, same),
      boundary_nodes,
      pieces_of_nodes(elements, nodes, false),
      pieces_of_nodes(elements, traction_nodes, true)};
}

void copy_kept_columns(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to) {
  for (std::size_t n = 0; n < kept.size(); ++n)
    if (kept[n] >= 0) to.middleCols<2>(2 * static_cast<Eigen::Index>(n)) = from.middleCols<2>(2 * kept[n]);
}

void copy_kept_blocks(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to) {
  for (std::size_t b = 0; b < kept.size(); ++b)
    for (std::size_t a = 0; kept[b] >= 0 && a < kept.size(); ++a)
      if (kept[a] >= 0)
        to.block<2, 2>(2 * static_cast<Eigen::Index>(a), 2 * static_cast<Eigen::Index>(b)) =
            from.block<2, 2>(2 * kept[a], 2 * kept[b]);
}

void copy_kept(const KnownBlocks& known, GalerkinMatrices& matrices) {
  // Blocks between nodes of different pieces are not copied, because such nodes do not act on each other.
  const KeptNodes& kept = known.kept;
  const auto index = [](std::size_t n) { return 2 * static_cast<Eigen::Index>(n); };
  for (std::size_t b = 0; b < kept.nodes.size(); ++b)
    for (std::size_t a = 0; kept.nodes[b] >= 0 && a < kept.nodes.size(); ++a)
      if (kept.nodes[a] >= 0 && kept.pieces[a] == kept.pieces[b])
        matrices.hypersingular.block<2, 2>(index(a), index(b)) =
            known.matrices.hypersingular.block<2, 2>(2 * kept.nodes[a], 2 * kept.nodes[b]);
  const std::vector<int>& tractions = kept.traction_nodes;
  for (std::size_t b = 0; b < tractions.size(); ++b) {
    if (tractions[b] < 0) continue;
    for (std::size_t a = b; a < tractions.size(); ++a) {
      if (tractions[a] < 0 || kept.traction_pieces[a] != kept.traction_pieces[b]) continue;
      const auto& from = known.matrices.single_layer;
      if (tractions[a] >= tractions[b]) {
        matrices.single_layer.block<2, 2>(index(a), index(b)) = from.block<2, 2>(2 * tractions[a], 2 * tractions[b]);
      } else {
        matrices.single_layer.block<2, 2>(index(a), index(b)) =
            from.block<2, 2>(2 * tractions[b], 2 * tractions[a]).transpose();
      }
    }
    for (std::size_t a = 0; a < kept.nodes.size(); ++a)
      if (kept.has_mixed_block(static_cast<int>(a), static_cast<int>(b)) && kept.pieces[a] == kept.traction_pieces[b])
        matrices.double_layer.block<2, 2>(index(a), index(b)) =
            known.matrices.double_layer.block<2, 2>(2 * kept.nodes[a], 2 * tractions[b]);
  }
}

}  // namespace bempd::bem

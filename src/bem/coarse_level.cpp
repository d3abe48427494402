#include "bem/coarse_level.hpp"

#include <algorithm>
#include <utility>

namespace bempd::bem {

namespace {

using Map = Eigen::SparseMatrix<double>;

// Interpolation of nodal values of a mesh from the nodes that remain after pairs of elements were merged (coarse level)
// to all nodes.
class Merging {
 public:
  explicit Merging(int nodes) : keeps_(nodes, 1) {}

  // Merges two elements, the second of which starts where the first one ends. Their common node becomes the mid node of
  // the merged element. The coarse value of this node belongs to the middle of the merged element, even if the two
  // elements meet elsewhere. `first_share` is the length of the first element over the length of both, `sweep` the
  // angle of the merged arc.
  void merge(const std::array<int, 3>& first, const std::array<int, 3>& second, double first_share, double sweep) {
    const ElementGeometry whole{Point::Zero(), Point::UnitX(), Point::Zero(), ElementBasis(0.5 * sweep)};
    const double joint = -1 + 2 * first_share;
    const std::array<int, 3> coarse{first[0], first[2], second[2]};
    for (const auto& [node, at] : {std::pair(first[1], 0.5 * (joint - 1)), std::pair(first[2], joint),
                                   std::pair(second[1], 0.5 * (joint + 1))}) {
      const auto shape = whole.shape(at);
      for (int k = 0; k < 3; ++k) entries_.push_back({node, coarse[k], shape[k]});
      keeps_[node] = 0;
    }
    middles_.push_back(first[2]);
  }

  // Interpolation matrix: gives the values of all nodes from the values of the nodes that remain on the coarse level
  // (mesh of merged elements), two components per node.
  Map map() const {
    const std::vector<int> columns = numbers();
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int node, int from, double value) {
      for (int c = 0; c < 2; ++c) entries.emplace_back(2 * node + c, 2 * columns[from] + c, value);
    };
    for (std::size_t n = 0; n < keeps_.size(); ++n)
      if (keeps_[n]) add(static_cast<int>(n), static_cast<int>(n), 1);
    for (const Entry& e : entries_) add(e.node, e.from, e.value);
    Map map(2 * static_cast<Eigen::Index>(keeps_.size()), 2 * left());
    map.setFromTriplets(entries.begin(), entries.end());
    return map;
  }

  // Matrix that selects, from the values of all nodes, the values of the nodes that remain on the coarse level (mesh of
  // merged elements), two components per node.
  Map selection() const {
    const std::vector<int> rows = numbers();
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t n = 0; n < rows.size(); ++n)
      for (int c = 0; rows[n] >= 0 && c < 2; ++c)
        entries.emplace_back(2 * rows[n] + c, 2 * static_cast<int>(n) + c, 1.0);
    Map map(2 * left(), 2 * static_cast<Eigen::Index>(rows.size()));
    map.setFromTriplets(entries.begin(), entries.end());
    return map;
  }

 private:
  // Number of each node among the nodes that remain after pairs of elements were merged; -1 for removed nodes.
  std::vector<int> numbers() const {
    std::vector<char> stays = keeps_;
    for (const int node : middles_) stays[node] = 1;
    std::vector<int> numbers(stays.size(), -1);
    int next = 0;
    for (std::size_t n = 0; n < stays.size(); ++n)
      if (stays[n]) numbers[n] = next++;
    return numbers;
  }
  int left() const { return static_cast<int>(std::count(keeps_.begin(), keeps_.end(), 1) + middles_.size()); }

  struct Entry {
    int node, from;
    double value;
  };
  std::vector<char> keeps_;
  std::vector<int> middles_;
  std::vector<Entry> entries_;
};

bool parallel(const CrackMesh& cracks, const CrackElement& a, const CrackElement& b) {
  const Point u = cracks.nodes[a.nodes[2]] - cracks.nodes[a.nodes[0]];
  const Point v = cracks.nodes[b.nodes[2]] - cracks.nodes[b.nodes[0]];
  return std::abs(cross(u, v)) <= 1e-9 * u.dot(v);
}

struct Merged {
  Merging values, tractions;
};

Merged merge_pairs(const BoundaryMesh& mesh, const CrackMesh& cracks) {
  const int boundary = static_cast<int>(mesh.nodes.size());
  Merged merged{Merging(boundary + static_cast<int>(cracks.nodes.size())), Merging(mesh.traction_node_count)};
  for (std::size_t e = 0; e + 1 < mesh.elements.size(); ++e) {
    const BoundaryElement &a = mesh.elements[e], &b = mesh.elements[e + 1];
    if (a.panel != b.panel || (a.sweep == 0) != (b.sweep == 0)) continue;
    const auto length = [&](const BoundaryElement& element) {
      return Arc{mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[2]], element.sweep}.length();
    };
    const double share = length(a) / (length(a) + length(b)), sweep = a.sweep + b.sweep;
    merged.values.merge(a.nodes, b.nodes, share, sweep);
    merged.tractions.merge(a.traction_nodes, b.traction_nodes, share, sweep);
    ++e;
  }
  const auto moved = [&](std::array<int, 3> nodes) {
    for (int& n : nodes) n += boundary;
    return nodes;
  };
  for (std::size_t e = 0; e + 1 < cracks.elements.size(); ++e) {
    const CrackElement &a = cracks.elements[e], &b = cracks.elements[e + 1];
    if (a.line != b.line || a.tip != TipEnd::none || b.tip != TipEnd::none || !parallel(cracks, a, b)) continue;
    merged.values.merge(moved(a.nodes), moved(b.nodes), (a.to - a.from) / (b.to - a.from), 0);
    ++e;
  }
  return merged;
}

// Map from the unknowns of the coarse level to the displacements and openings of all nodes. Constraints between
// openings at joints (places where crack lines meet) are taken over only where they belong to nodes of the coarse
// level.
Map from_coarse_unknowns(const Merging& merging, const Map& from_unknowns) {
  const Map some = merging.selection() * from_unknowns;
  std::vector<Eigen::Triplet<double>> entries;
  int columns = 0;
  for (Eigen::Index c = 0; c < some.outerSize(); ++c) {
    bool empty = true;
    for (Map::InnerIterator i(some, c); i; ++i) {
      empty = false;
      entries.emplace_back(i.row(), columns, i.value());
    }
    if (!empty) ++columns;
  }
  Map kept(some.rows(), columns);
  kept.setFromTriplets(entries.begin(), entries.end());
  return merging.map() * kept;
}

// Adds a stiffness against the rigid motions of every piece of the body, so that the matrix becomes positive definite.
// The solution does not change, because forces in equilibrium do no work on rigid motions. Openings are zero in rigid
// motions.
void hold_rigid_motions(const CrackedOperator& body, const Map& map, Eigen::MatrixXd& stiffness) {
  const BoundaryMesh& mesh = body.mesh();
  const int pieces = body.cracks().pieces.count;
  std::vector<Eigen::MatrixXd> motions(static_cast<std::size_t>(pieces), Eigen::MatrixXd::Zero(map.rows(), 3));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const int node : mesh.elements[e].nodes) {
      const Point x = body.boundary().scaled(mesh.nodes[node]);
      motions[body.elements()[e].piece].middleRows<2>(2 * static_cast<Eigen::Index>(node)) << 1, 0, -x.y(), 0, 1, x.x();
    }
  const double mean = stiffness.trace() / static_cast<double>(stiffness.rows());
  for (const Eigen::MatrixXd& motion : motions) {
    const Eigen::MatrixXd held = map.transpose() * motion;
    const double scale = mean / held.col(0).squaredNorm();
    stiffness += scale * held * held.transpose();
  }
}

}  // namespace

CrackedState coarse_state(const CrackedOperator& body, const CrackedState& state) {
  const GalerkinMatrices& fine = body.matrices();
  const double shear = body.elasticity().shear_modulus(), length = body.boundary().length;
  const Merged merged = merge_pairs(body.mesh(), body.cracks());
  const Map values = from_coarse_unknowns(merged.values, from_unknowns(body.mesh(), body.cracks()));
  const Map tractions = merged.tractions.map();
  linalg::DenseCholesky single_layer;
  single_layer.compute(congruent(fine.single_layer, tractions));
  const Eigen::MatrixXd double_layer = transposed_product(values, fine.double_layer) * tractions;
  Eigen::MatrixXd stiffness = congruent(fine.hypersingular, values);
  add_forces_of_tractions(double_layer, single_layer, stiffness);
  hold_rigid_motions(body, values, stiffness);

  // Forces that hold the given state in equilibrium, divided by thickness and shear modulus.
  Eigen::VectorXd all(fine.hypersingular.rows());
  all << state.displacements, state.openings;
  const Eigen::VectorXd forces = fine.hypersingular * all + fine.double_layer * (length / shear * state.tractions);
  linalg::DenseCholesky cholesky;
  cholesky.compute(std::move(stiffness));
  const Eigen::VectorXd unknowns = cholesky.solve(Eigen::VectorXd(values.transpose() * forces));
  const Eigen::VectorXd solution = values * unknowns;
  const Eigen::VectorXd traction = tractions * single_layer.solve(double_layer.transpose() * unknowns);
  const Eigen::Index u = state.displacements.size();
  return {solution.head(u),          solution.tail(solution.size() - u),
          shear / length * traction, state.face_traction,
          state.faces_press,         state.closed};
}

}  // namespace bempd::bem

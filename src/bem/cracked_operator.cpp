#include "bem/cracked_operator.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "error.hpp"

namespace bempd::bem {

namespace {

// Number of the position of each node at an end of elements. Nodes that were split at a crack mouth have the same
// number, and so have the ends of cracks at a joint.
std::vector<int> position_numbers(const BoundaryMesh& mesh, const CrackMesh& cracks) {
  const int boundary = static_cast<int>(mesh.nodes.size());
  std::vector<int> places(static_cast<std::size_t>(boundary) + cracks.nodes.size());
  std::iota(places.begin(), places.end(), 0);
  std::map<int, int> place_of_joint;
  for (std::size_t j = 0; j < cracks.nodes_at_joint.size(); ++j) {
    const std::vector<int>& nodes = cracks.nodes_at_joint[j];
    if (nodes.empty()) continue;
    place_of_joint[static_cast<int>(j)] = nodes.front();
    for (const int node : nodes) places[node] = nodes.front();
  }
  for (std::size_t n = 0; n < cracks.nodes.size(); ++n)
    if (const int joint = cracks.joint_of_node[n]; joint >= 0)
      places[boundary + n] = place_of_joint.emplace(joint, boundary + static_cast<int>(n)).first->second;
  return places;
}

// Product with the transpose of a sparse map. Most columns of the map are unit vectors whose rows are consecutive; for
// such runs of columns the components are copied.
class TransposedMap {
 public:
  explicit TransposedMap(const Eigen::SparseMatrix<double>& map) : map_(map) {
    for (Eigen::Index c = 0; c < map.cols(); ++c) {
      const Eigen::Index row = row_of_unit(c);
      if (row < 0) {
        others_.push_back(c);
        continue;
      }
      const bool goes_on =
          !runs_.empty() && runs_.back().column + runs_.back().size == c && runs_.back().row + runs_.back().size == row;
      if (!goes_on) runs_.push_back({c, row, 0});
      ++runs_.back().size;
    }
  }

  // Row of the single entry 1 of a column; -1 if the column is no unit vector.
  Eigen::Index row_of_unit(Eigen::Index column) const {
    const int first = map_.outerIndexPtr()[column];
    const bool unit = map_.outerIndexPtr()[column + 1] == first + 1 && map_.valuePtr()[first] == 1;
    return unit ? map_.innerIndexPtr()[first] : -1;
  }

  // Computes the components of map^T column from number `first` on; earlier components of `result` stay as they are.
  void apply(const double* column, Eigen::Index first, double* result) const {
    for (const Run& run : runs_) {
      const Eigen::Index skipped = std::clamp(first - run.column, Eigen::Index{0}, run.size);
      std::copy_n(column + run.row + skipped, run.size - skipped, result + run.column + skipped);
    }
    const int *ends = map_.outerIndexPtr(), *rows = map_.innerIndexPtr();
    for (const Eigen::Index c : others_) {
      if (c < first) continue;
      double sum = 0;
      for (int k = ends[c]; k < ends[c + 1]; ++k) sum += map_.valuePtr()[k] * column[rows[k]];
      result[c] = sum;
    }
  }

 private:
  struct Run {
    Eigen::Index column, row, size;
  };
  const Eigen::SparseMatrix<double>& map_;
  std::vector<Run> runs_;
  std::vector<Eigen::Index> others_;
};

// Node in the earlier body for each node of the unknowns: the node that stands for the same displacements and openings;
// -1 for new nodes. `map` and `map_before` give displacements and openings from the unknowns of each body; `kept_nodes`
// has the number of each node in the earlier body.
std::vector<int> kept_unknowns(const std::vector<int>& kept_nodes, const Eigen::SparseMatrix<double>& map,
                               const Eigen::SparseMatrix<double>& map_before) {
  using Meaning = std::vector<std::pair<int, double>>;
  const auto meaning = [](const Eigen::SparseMatrix<double>& from, Eigen::Index node) {
    Meaning entries;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(from, 2 * node); entry; ++entry)
      entries.emplace_back(static_cast<int>(entry.row() / 2), entry.value());
    return entries;
  };
  std::map<Meaning, int> before;
  for (Eigen::Index node = 0; 2 * node < map_before.cols(); ++node)
    before.emplace(meaning(map_before, node), static_cast<int>(node));
  std::vector<int> kept;
  for (Eigen::Index node = 0; 2 * node < map.cols(); ++node) {
    Meaning entries = meaning(map, node);
    for (auto& [raw, value] : entries) raw = kept_nodes[raw];
    std::sort(entries.begin(), entries.end());
    const auto found = before.find(entries);
    kept.push_back(found == before.end() ? -1 : found->second);
  }
  return kept;
}

}  // namespace

std::vector<GalerkinElement> cracked_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary,
                                                       const CrackMesh& cracks) {
  const std::vector<int> places = position_numbers(mesh, cracks);
  std::vector<GalerkinElement> elements = boundary_galerkin_elements(mesh, boundary);
  for (GalerkinElement& e : elements) e.places = {places[e.nodes[0]], places[e.nodes[2]]};
  for (std::size_t e = 0; e < cracks.pieces.of_element.size(); ++e) elements[e].piece = cracks.pieces.of_element[e];
  const int first = static_cast<int>(mesh.nodes.size());
  for (const CrackElement& e : cracks.elements) {
    const Point start = boundary.scaled(cracks.nodes[e.nodes[0]]), end = boundary.scaled(cracks.nodes[e.nodes[2]]);
    const ElementGeometry geometry =
        e.tip == TipEnd::none ? element_through(start, 0.5 * (start + end), end, 0) : tip_element(start, end, e.tip);
    elements.push_back({geometry,
                        {first + e.nodes[0], first + e.nodes[1], first + e.nodes[2]},
                        {-1, -1, -1},
                        {places[first + e.nodes[0]], places[first + e.nodes[2]]},
                        true,
                        e.piece});
  }
  return elements;
}

Eigen::SparseMatrix<double> from_unknowns(const BoundaryMesh& mesh, const CrackMesh& cracks) {
  const Eigen::Index displacements = 2 * static_cast<Eigen::Index>(mesh.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < displacements; ++i) entries.emplace_back(i, i, 1.0);
  for (Eigen::Index column = 0; column < cracks.constraint.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator i(cracks.constraint, column); i; ++i)
      entries.emplace_back(displacements + i.row(), column, i.value());
  Eigen::SparseMatrix<double> map(displacements + cracks.constraint.rows(), cracks.constraint.cols());
  map.setFromTriplets(entries.begin(), entries.end());
  return map;
}

CrackedOperator::CrackedOperator(const BoundaryMesh& mesh, const CrackMesh& cracks, const PlaneElasticity& elasticity,
                                 const AssemblyOptions& options, const CrackedOperator* before)
    : mesh_(mesh),
      elasticity_(elasticity),
      options_(options),
      boundary_(mesh),
      elements_(cracked_galerkin_elements(mesh, boundary_, cracks)) {
  cracks_ = cracks;  // Eigen's constructors keep a part of their memory where the rest is missing
  if (before && (before->boundary_.centre != boundary_.centre || before->boundary_.length != boundary_.length ||
                 before->elasticity_ != elasticity))
    before = nullptr;
  const int on_boundary = static_cast<int>(mesh_.nodes.size());
  const int nodes = on_boundary + static_cast<int>(cracks_.nodes.size()), tractions = mesh_.traction_node_count;
  KeptNodes kept;
  if (before) kept = kept_nodes(before->elements_, elements_, on_boundary, nodes, tractions);
  const KnownBlocks known{kept, before ? before->matrices_ : matrices_};
  matrices_ = assemble_galerkin(elements_, nodes, tractions, elasticity.effective_poisson_ratio(), options,
                                before ? &known : nullptr);
  kernel_evaluations_ = matrices_.kernel_evaluations;
  copy_lower_to_upper(matrices_.hypersingular);
  copy_lower_to_upper(matrices_.single_layer);
  if (before && kept.whole_boundary) {
    single_layer_ = before->single_layer_;
  } else {
    auto single_layer = std::make_shared<linalg::DenseCholesky>();
    single_layer->compute(matrices_.single_layer);
    require_positive(*single_layer);
    single_layer_ = std::move(single_layer);
  }
  const Eigen::SparseMatrix<double> map = from_unknowns(mesh, cracks);
  std::vector<int> unknowns;
  if (before) {
    take_from(*before, kept);
    full_ = congruent(raw_, map);
    copy_lower_to_upper(full_);
    unknowns = kept_unknowns(kept.nodes, map, from_unknowns(before->mesh_, before->cracks_));
  } else {
    full_ = congruent(matrices_.hypersingular, map);
    add_forces_of_tractions(transposed_product(map, matrices_.double_layer), *single_layer_, full_);
  }
  full_ *= elasticity.thickness * elasticity.shear_modulus();
  of_openings_.compute(full_, 2 * static_cast<Eigen::Index>(on_boundary),
                       kept.whole_boundary ? &before->of_openings_ : nullptr, unknowns);
}

// Computes L^-1 B and D + B^T V^-1 B, where D, B and V = L L^T are the Galerkin matrices. The parts that `before` has
// are copied, so that only columns of new nodes cost work.
void CrackedOperator::take_from(const CrackedOperator& before, const KeptNodes& kept) {
  const Eigen::Index size = matrices_.hypersingular.rows();
  const bool knows = kept.whole_boundary && before.reduced_.size() > 0;
  std::vector<Eigen::Index> fresh;
  for (Eigen::Index n = 0; 2 * n < size; ++n)
    if (!knows || kept.nodes[static_cast<std::size_t>(n)] < 0) fresh.insert(fresh.end(), {2 * n, 2 * n + 1});
  reduced_.resize(matrices_.single_layer.rows(), size);
  if (knows) copy_kept_columns(kept.nodes, before.reduced_, reduced_);
  raw_.resize(size, size);
  if (knows) copy_kept_blocks(kept.nodes, before.raw_, raw_);
  if (fresh.empty()) return;
  Eigen::MatrixXd columns = matrices_.double_layer(fresh, Eigen::all).transpose();
  linalg::solve_lower(single_layer_->lower(), columns);
  for (std::size_t k = 0; k < fresh.size(); ++k) reduced_.col(fresh[k]) = columns.col(static_cast<Eigen::Index>(k));
  const Eigen::MatrixXd products = reduced_.transpose() * columns;
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    raw_.col(fresh[k]) = matrices_.hypersingular.col(fresh[k]) + products.col(static_cast<Eigen::Index>(k));
    raw_.row(fresh[k]) = raw_.col(fresh[k]).transpose();
  }
}

Eigen::MatrixXd transposed_product(const Eigen::SparseMatrix<double>& map, const Eigen::MatrixXd& a) {
  Eigen::MatrixXd result(map.cols(), a.cols());
  const TransposedMap transposed(map);
  for (Eigen::Index j = 0; j < a.cols(); ++j) transposed.apply(a.col(j).data(), 0, result.col(j).data());
  return result;
}

Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::SparseMatrix<double>& map) {
  Eigen::MatrixXd result(map.cols(), map.cols());
  const TransposedMap transposed(map);
  Eigen::VectorXd column(a.rows());
  for (Eigen::Index j = 0; j < map.cols(); ++j) {
    if (const Eigen::Index row = transposed.row_of_unit(j); row >= 0) {
      transposed.apply(a.col(row).data(), j, result.col(j).data());
      continue;
    }
    column.setZero();
    for (Eigen::SparseMatrix<double>::InnerIterator entry(map, j); entry; ++entry)
      column += entry.value() * a.col(entry.row());
    transposed.apply(column.data(), j, result.col(j).data());
  }
  return result;
}

void add_forces_of_tractions(Eigen::MatrixXd double_layer, const linalg::DenseCholesky& single_layer,
                             Eigen::MatrixXd& stiffness) {
  linalg::solve_upper_from_right(single_layer.lower(), double_layer);
  linalg::add_square(stiffness, double_layer);
  copy_lower_to_upper(stiffness);
}

Eigen::MatrixXd CrackedOperator::forces_on_boundary(const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const {
  const Eigen::MatrixXd forces = cracks_.constraint.transpose() * opening_forces;
  const Eigen::Index u = stiffness().rows(), w = full_.rows() - u;
  return forces.topRows(u) - full_.topRightCorner(u, w) * of_openings_.solve(forces.bottomRows(w));
}

Eigen::MatrixXd CrackedOperator::openings(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                                          const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const {
  const Eigen::MatrixXd forces = cracks_.constraint.transpose() * opening_forces;
  const Eigen::Index u = stiffness().rows(), w = full_.rows() - u;
  Eigen::MatrixXd unknowns(full_.rows(), displacements.cols());
  unknowns.topRows(u) = displacements;
  unknowns.bottomRows(w) = of_openings_.solve(forces.bottomRows(w) - full_.bottomLeftCorner(w, u) * displacements);
  return cracks_.constraint * unknowns;
}

Eigen::MatrixXd CrackedOperator::tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const {
  const Eigen::Index openings_count = cracks_.constraint.rows();
  return tractions(displacements, openings(displacements, Eigen::MatrixXd::Zero(openings_count, displacements.cols())));
}

Eigen::MatrixXd CrackedOperator::tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                                           const Eigen::Ref<const Eigen::MatrixXd>& openings) const {
  const auto& rows = matrices_.double_layer;
  const Eigen::Index u = stiffness().rows();
  const Eigen::MatrixXd right =
      rows.topRows(u).transpose() * displacements + rows.bottomRows(rows.rows() - u).transpose() * openings;
  return elasticity_.shear_modulus() / boundary_.length * single_layer_->solve(right);
}

}  // namespace bempd::bem

#include "bem/galerkin_assembly.hpp"

#include <algorithm>
#include <atomic>

#include "bem/kept_blocks.hpp"
#include "bem/pair_blocks.hpp"
#include "cancellation.hpp"
#include "error.hpp"
#include "parallel.hpp"
#include "phase.hpp"

namespace bempd::bem {

namespace {

// Groups of elements in which no two elements share a node. Threads can assemble a group without conflict, and the
// order of sums does not depend on the threads.
std::vector<std::vector<int>> independent_groups(const std::vector<GalerkinElement>& elements, int nodes) {
  const int count = static_cast<int>(elements.size());
  std::vector<std::vector<int>> groups, touching(nodes);
  std::vector<int> group_of(count, -1);
  for (int e = 0; e < count; ++e)
    for (const int end : {0, 2}) touching[elements[e].nodes[end]].push_back(e);
  for (int e = 0; e < count; ++e) {
    int group = 0;
    const auto taken = [&] {
      for (const int end : {0, 2})
        for (const int other : touching[elements[e].nodes[end]])
          if (other != e && group_of[other] == group) return true;
      return false;
    };
    while (taken()) ++group;
    group_of[e] = group;
    if (group == static_cast<int>(groups.size())) groups.emplace_back();
    groups[group].push_back(e);
  }
  return groups;
}

class Assembler {
 public:
  Assembler(const std::vector<GalerkinElement>& elements, int nodes, int traction_nodes, double nu,
            const AssemblyOptions& options, const KnownBlocks* known)
      : elements_(elements),
        kept_(known ? &known->kept : nullptr),
        blocks_(elements, nu, options.quadrature_tolerance) {
    matrices.single_layer.setZero(2 * traction_nodes, 2 * traction_nodes);
    matrices.hypersingular.setZero(2 * nodes, 2 * nodes);
    matrices.double_layer.setZero(2 * nodes, 2 * traction_nodes);
  }

  // Adds all pairs with the given outer element, in the columns of that element; returns the number of kernel
  // evaluations. assemble_galerkin() completes `single_layer` and `hypersingular` by adding their transposes.
  std::int64_t add_outer(int outer) {
    std::int64_t evaluations = 0;
    const GalerkinElement& x = elements_[outer];
    // An outer crack element is paired with crack elements only, because boundary integral equations hold on the
    // boundary alone.
    for (int inner = x.crack ? outer : 0; inner < static_cast<int>(elements_.size()); ++inner) {
      if (inner % 32 == 0) check_cancelled();
      if (elements_[inner].piece != x.piece) continue;
      if (kept_ && kept_->has(x, elements_[inner])) continue;
      const PairPart part = inner < outer ? PairPart::double_layer_only
                            : x.crack     ? PairPart::derivative_only
                                          : PairPart::everything;
      const PairMoments moments = blocks_.moments(outer, inner, part);
      if (!x.crack) add_double_layer(outer, inner, moments);
      if (part != PairPart::double_layer_only) add_weakly_singular(outer, inner, moments);
      evaluations += moments.evaluations;
    }
    return evaluations;
  }

  GalerkinMatrices matrices;

 private:
  void add_weakly_singular(int outer, int inner, const PairMoments& m) {
    const GalerkinElement &x = elements_[outer], &y = elements_[inner];
    const bool tractions = !x.crack && !y.crack;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        if (tractions && !(kept_ && kept_->has_traction_block(y.traction_nodes[b], x.traction_nodes[a])))
          matrices.single_layer.block<2, 2>(2 * y.traction_nodes[b], 2 * x.traction_nodes[a]) +=
              blocks_.single_layer(outer, inner, m, a, b);
        if (!(kept_ && kept_->has_block(y.nodes[b], x.nodes[a])))
          matrices.hypersingular.block<2, 2>(2 * y.nodes[b], 2 * x.nodes[a]) +=
              blocks_.hypersingular(outer, inner, m, a, b);
      }
  }

  void add_double_layer(int outer, int inner, const PairMoments& m) {
    const GalerkinElement &x = elements_[outer], &y = elements_[inner];
    // A pair with an inner crack element has three functions, those of the nodes of the inner element. For inner
    // boundary elements a constant is subtracted from the displacements, because constant displacements cause no
    // forces; from openings nothing is subtracted, because constant openings do cause forces.
    const int functions = y.crack ? 3 : 6;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < functions; ++b) {
        const int node = b < 3 ? y.nodes[b] : x.nodes[b - 3];
        if (kept_ && kept_->has_mixed_block(node, x.traction_nodes[a])) continue;
        matrices.double_layer.block<2, 2>(2 * node, 2 * x.traction_nodes[a]) += blocks_.double_layer(m, a, b);
      }
  }

  const std::vector<GalerkinElement>& elements_;
  const KeptNodes* kept_;
  PairBlocks blocks_;
};

// Visits the lower triangle of a square matrix in tiles, so that the rows and the columns of a tile stay in the cache.
template <class Visit>
void each_in_lower(Eigen::Index size, const Visit& visit) {
  constexpr Eigen::Index tile = 32;
  for (Eigen::Index column = 0; column < size; column += tile)
    for (Eigen::Index row = column; row < size; row += tile)
      for (Eigen::Index j = column; j < std::min(column + tile, size); ++j)
        for (Eigen::Index i = std::max(row, j); i < std::min(row + tile, size); ++i) visit(i, j);
}

// Replaces the lower triangle of a by that of a + a^T.
void complete_lower(Eigen::MatrixXd& a) {
  each_in_lower(a.rows(), [&](Eigen::Index i, Eigen::Index j) { a(i, j) += a(j, i); });
}

}  // namespace

std::vector<GalerkinElement> boundary_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary) {
  std::vector<GalerkinElement> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const BoundaryElement& element = mesh.elements[e];
    elements.push_back(
        {boundary.elements[e], element.nodes, element.traction_nodes, {element.nodes[0], element.nodes[2]}});
  }
  return elements;
}

void require_positive(const Eigen::LLT<Eigen::MatrixXd>& single_layer) {
  if (single_layer.info() == Eigen::Success) return;
  fail(Failure::unsolvable,
       "the boundary operator of a region is numerically singular; its shape has parts too thin for its elements, or "
       "elements of too different length: give these parts shorter elements, or leave them out");
}

void copy_lower_to_upper(Eigen::MatrixXd& a) {
  each_in_lower(a.rows(), [&](Eigen::Index i, Eigen::Index j) { a(j, i) = a(i, j); });
}

GalerkinMatrices assemble_galerkin(const std::vector<GalerkinElement>& elements, int nodes, int traction_nodes,
                                   double nu, const AssemblyOptions& options, const KnownBlocks* known) {
  Assembler assembler(elements, nodes, traction_nodes, nu, options, known);
  const int threads = options.threads_for(elements.size());
  std::atomic<std::int64_t> evaluations = 0, done = 0;
  const Phase phase("boundary integrals", static_cast<double>(elements.size()));
  for (const std::vector<int>& group : independent_groups(elements, nodes)) {
    parallel_for(group.size(), threads, [&](std::size_t i) {
      evaluations += assembler.add_outer(group[i]);
      phase.reach(static_cast<double>(++done));
    });
  }
  assembler.matrices.kernel_evaluations = evaluations;
  complete_lower(assembler.matrices.single_layer);
  complete_lower(assembler.matrices.hypersingular);
  if (known) copy_kept(*known, assembler.matrices);
  return std::move(assembler.matrices);
}

}  // namespace bempd::bem

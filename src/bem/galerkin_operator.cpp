#include "bem/galerkin_operator.hpp"

#include <algorithm>
#include <atomic>
#include <numbers>

#include "bem/pair_integrals.hpp"
#include "cancellation.hpp"
#include "error.hpp"
#include "parallel.hpp"

namespace bempd::bem {

namespace {

// Every matrix is filled in columns of the outer element: `single_layer` and `hypersingular` are to be completed by
// adding their transposes, `double_layer` is B^T.
struct Operators {
  Eigen::MatrixXd single_layer, hypersingular, double_layer;
};

Contact contact_of(const BoundaryElement& outer, const BoundaryElement& inner) {
  const bool end_to_start = outer.nodes[2] == inner.nodes[0], start_to_end = outer.nodes[0] == inner.nodes[2];
  if (end_to_start && start_to_end) return Contact::both_ends;
  if (end_to_start) return Contact::end_to_start;
  return start_to_end ? Contact::start_to_end : Contact::none;
}

// Groups of elements of which no two share a node: one group can be assembled by many threads without conflict, and
// sums keep their order.
std::vector<std::vector<int>> independent_groups(const BoundaryMesh& mesh) {
  const int count = static_cast<int>(mesh.elements.size());
  std::vector<std::vector<int>> groups, touching(mesh.nodes.size());
  std::vector<int> group_of(count, -1);
  for (int e = 0; e < count; ++e)
    for (const int end : {0, 2}) touching[mesh.elements[e].nodes[end]].push_back(e);
  for (int e = 0; e < count; ++e) {
    int group = 0;
    const auto taken = [&] {
      for (const int end : {0, 2})
        for (const int other : touching[mesh.elements[e].nodes[end]])
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

// Symmetric 2 x 2 blocks  isotropic * I + factor * (cosine, sine; sine, -cosine).
Eigen::Matrix2d symmetric_block(double isotropic, double cosine, double sine) {
  Eigen::Matrix2d block;
  block << isotropic + cosine, sine, sine, isotropic - cosine;
  return block;
}

class Assembler {
 public:
  Assembler(const BoundaryMesh& mesh, double nu, const AssemblyOptions& options)
      : mesh_(mesh), nu_(nu), boundary_(mesh), integrator_(boundary_.elements, options.quadrature_tolerance) {
    const int tractions = 2 * mesh.traction_node_count, displacements = 2 * static_cast<int>(mesh.nodes.size());
    operators.single_layer.setZero(tractions, tractions);
    operators.hypersingular.setZero(displacements, displacements);
    operators.double_layer.setZero(displacements, tractions);
    for (const ElementGeometry& e : boundary_.elements) node_lengths_.push_back(shape_integrals(e));
  }

  // All pairs whose outer element is given.
  std::int64_t add_outer(int outer) {
    std::int64_t evaluations = 0;
    for (int inner = 0; inner < static_cast<int>(mesh_.elements.size()); ++inner) {
      check_cancelled();
      const Contact contact = inner == outer ? Contact::same : contact_of(mesh_.elements[outer], mesh_.elements[inner]);
      const PairPart part = inner >= outer ? PairPart::everything : PairPart::double_layer_only;
      const PairMoments moments = integrator_.integrate(outer, inner, contact, part);
      add_double_layer(outer, inner, moments);
      if (part == PairPart::everything) add_weakly_singular(outer, inner, moments);
      evaluations += moments.evaluations;
    }
    return evaluations;
  }

  double length() const { return boundary_.length; }

  Operators operators;

 private:
  static std::array<double, 3> shape_integrals(const ElementGeometry& element) {
    ElementPoints points;
    fill_points(element, {}, max_regular_points, points);
    std::array<double, 3> sums{};
    for (int k = 0; k < 3; ++k)
      for (int p = 0; p < points.count; ++p) sums[k] += points.mass[k][p];
    return sums;
  }

  void add_weakly_singular(int outer, int inner, const PairMoments& m) {
    const BoundaryElement &x = mesh_.elements[outer], &y = mesh_.elements[inner];
    // The block of an element with itself comes back with the transpose.
    const double half = outer == inner ? 0.5 : 1.0;
    const double single = half / (8 * std::numbers::pi * (1 - nu_)), hyper = half / (2 * std::numbers::pi * (1 - nu_));
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        // Trace part 1/2 of e e^T: a product of integrals here, nothing in the closed loops of D.
        const double trace = 0.5 * node_lengths_[outer][a] * node_lengths_[inner][b];
        operators.single_layer.block<2, 2>(2 * y.traction_nodes[b], 2 * x.traction_nodes[a]) +=
            single * symmetric_block(trace - (3 - 4 * nu_) * m.mass[0][b][a], m.mass[1][b][a], m.mass[2][b][a]);
        operators.hypersingular.block<2, 2>(2 * y.nodes[b], 2 * x.nodes[a]) +=
            hyper * symmetric_block(-m.derivative[0][b][a], m.derivative[1][b][a], m.derivative[2][b][a]);
      }
  }

  void add_double_layer(int outer, int inner, const PairMoments& m) {
    const BoundaryElement &x = mesh_.elements[outer], &y = mesh_.elements[inner];
    const double factor = -1 / (4 * std::numbers::pi * (1 - nu_));
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 6; ++b) {
        const int node = b < 3 ? y.nodes[b] : x.nodes[b - 3];
        const auto& moment = m.double_layer;
        const double rotation = (1 - 2 * nu_) * moment[1][b][a];
        Eigen::Matrix2d transposed =
            symmetric_block((2 - 2 * nu_) * moment[0][b][a], 2 * moment[2][b][a], 2 * moment[3][b][a]);
        transposed(1, 0) += rotation;
        transposed(0, 1) -= rotation;
        operators.double_layer.block<2, 2>(2 * node, 2 * x.traction_nodes[a]) += factor * transposed;
      }
  }

  const BoundaryMesh& mesh_;
  double nu_;
  ScaledBoundary boundary_;
  PairIntegrator integrator_;
  std::vector<std::array<double, 3>> node_lengths_;
};

// Visits the lower triangle by square tiles, so that the rows of a tile and its columns both stay in the cache.
template <class Visit>
void each_in_lower(Eigen::Index size, const Visit& visit) {
  constexpr Eigen::Index tile = 32;
  for (Eigen::Index column = 0; column < size; column += tile)
    for (Eigen::Index row = column; row < size; row += tile)
      for (Eigen::Index j = column; j < std::min(column + tile, size); ++j)
        for (Eigen::Index i = std::max(row, j); i < std::min(row + tile, size); ++i) visit(i, j);
}

// Lower triangle of a + a^T, in place.
void complete_lower(Eigen::MatrixXd& a) {
  each_in_lower(a.rows(), [&](Eigen::Index i, Eigen::Index j) { a(i, j) += a(j, i); });
}

void copy_lower_to_upper(Eigen::MatrixXd& a) {
  each_in_lower(a.rows(), [&](Eigen::Index i, Eigen::Index j) { a(j, i) = a(i, j); });
}

}  // namespace

GalerkinOperator::GalerkinOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                                   const AssemblyOptions& options) {
  Assembler assembler(mesh, elasticity.effective_poisson_ratio(), options);
  const int threads = options.threads_for(mesh.elements.size());
  std::atomic<std::int64_t> evaluations = 0;
  for (const std::vector<int>& group : independent_groups(mesh)) {
    parallel_for(group.size(), threads, [&](std::size_t i) { evaluations += assembler.add_outer(group[i]); });
  }
  kernel_evaluations_ = evaluations;

  Operators& operators = assembler.operators;
  complete_lower(operators.single_layer);
  single_layer_.compute(operators.single_layer);
  check_cancelled();
  if (single_layer_.info() != Eigen::Success) {
    fail(Failure::unsolvable,
         "the boundary operator of a region is numerically singular; its shape has parts too thin for its elements, or "
         "elements of too different length: give these parts shorter elements, or leave them out");
  }
  reduced_transpose_ = std::move(operators.double_layer);
  single_layer_.matrixU().solveInPlace<Eigen::OnTheRight>(reduced_transpose_);
  check_cancelled();

  stiffness_ = std::move(operators.hypersingular);
  complete_lower(stiffness_);
  stiffness_.selfadjointView<Eigen::Lower>().rankUpdate(reduced_transpose_);
  stiffness_ *= elasticity.thickness * elasticity.shear_modulus();
  copy_lower_to_upper(stiffness_);
  traction_scale_ = elasticity.shear_modulus() / assembler.length();
}

Eigen::MatrixXd GalerkinOperator::tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const {
  Eigen::MatrixXd t = reduced_transpose_.transpose() * displacements;
  single_layer_.matrixU().solveInPlace(t);
  return traction_scale_ * t;
}

}  // namespace bempd::bem

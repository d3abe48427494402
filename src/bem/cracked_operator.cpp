#include "bem/cracked_operator.hpp"

#include <map>

#include "error.hpp"

namespace bempd::bem {

namespace {

// Places of nodes at which elements end, numbered like nodes: those split at a mouth have one in common, and so have
// the ends of cracks at a joint.
std::vector<int> places_of(const BoundaryMesh& mesh, const CrackMesh& cracks) {
  const int boundary = static_cast<int>(mesh.nodes.size());
  std::vector<int> places;
  for (int n = 0; n < boundary + static_cast<int>(cracks.nodes.size()); ++n) places.push_back(n);
  std::map<int, int> place_of_joint;
  for (std::size_t j = 0; j < cracks.mouth_of_joint.size(); ++j) {
    const auto [before, after] = cracks.mouth_of_joint[j];
    if (before < 0) continue;
    place_of_joint[static_cast<int>(j)] = before;
    places[after] = before;
  }
  for (std::size_t n = 0; n < cracks.nodes.size(); ++n)
    if (const int joint = cracks.joint_of_node[n]; joint >= 0)
      places[boundary + n] = place_of_joint.emplace(joint, boundary + static_cast<int>(n)).first->second;
  return places;
}

}  // namespace

std::vector<GalerkinElement> cracked_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary,
                                                       const CrackMesh& cracks) {
  const std::vector<int> places = places_of(mesh, cracks);
  std::vector<GalerkinElement> elements = boundary_galerkin_elements(mesh, boundary);
  for (GalerkinElement& e : elements) e.places = {places[e.nodes[0]], places[e.nodes[2]]};
  const int first = static_cast<int>(mesh.nodes.size());
  for (const CrackElement& e : cracks.elements) {
    const Point start = boundary.scaled(cracks.nodes[e.nodes[0]]), end = boundary.scaled(cracks.nodes[e.nodes[2]]);
    const ElementGeometry geometry =
        e.tip == TipEnd::none ? element_through(start, 0.5 * (start + end), end, 0) : tip_element(start, end, e.tip);
    elements.push_back({geometry,
                        {first + e.nodes[0], first + e.nodes[1], first + e.nodes[2]},
                        {-1, -1, -1},
                        {places[first + e.nodes[0]], places[first + e.nodes[2]]},
                        true});
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
                                 const AssemblyOptions& options)
    : mesh_(mesh),
      cracks_(cracks),
      elasticity_(elasticity),
      options_(options),
      boundary_(mesh),
      elements_(cracked_galerkin_elements(mesh, boundary_, cracks)) {
  const int nodes = static_cast<int>(mesh.nodes.size() + cracks.nodes.size());
  matrices_ =
      assemble_galerkin(elements_, nodes, mesh.traction_node_count, elasticity.effective_poisson_ratio(), options);
  kernel_evaluations_ = matrices_.kernel_evaluations;
  copy_lower_to_upper(matrices_.hypersingular);
  single_layer_.compute(matrices_.single_layer);
  require_positive(single_layer_);
  full_ = stiffness_of(matrices_, single_layer_, from_unknowns(mesh, cracks)) *
          (elasticity.thickness * elasticity.shear_modulus());
  eliminate_openings();
}

Eigen::MatrixXd stiffness_of(const GalerkinMatrices& matrices, const linalg::DenseCholesky& single_layer,
                             const Eigen::SparseMatrix<double>& map) {
  Eigen::MatrixXd reduced = map.transpose() * matrices.double_layer;
  linalg::solve_upper_from_right(single_layer.lower(), reduced);
  const Eigen::MatrixXd half = matrices.hypersingular * map;
  Eigen::MatrixXd stiffness = map.transpose() * half;
  linalg::add_square(stiffness, reduced);
  copy_lower_to_upper(stiffness);
  return stiffness;
}

void CrackedOperator::eliminate_openings() {
  const Eigen::Index u = 2 * static_cast<Eigen::Index>(mesh_.nodes.size()), w = full_.rows() - u;
  of_openings_.compute(full_.bottomRightCorner(w, w));
  // A motion of the piece needs no force; its pivot is rounding.
  constexpr double least_pivot = 1e-12;
  const Eigen::ArrayXd pivots = of_openings_.matrixLLT().diagonal().array().square();
  require(of_openings_.info() == Eigen::Success &&
              (pivots > least_pivot * full_.bottomRightCorner(w, w).diagonal().array()).all(),
          "cracks cut a piece out of a body that nothing holds; leave a ligament or end one of them earlier");
  Eigen::MatrixXd half = full_.bottomLeftCorner(w, u);
  linalg::solve_lower(of_openings_.lower(), half);
  stiffness_ = full_.topLeftCorner(u, u);
  linalg::add_square(stiffness_, half.transpose(), -1);
  copy_lower_to_upper(stiffness_);
}

Eigen::MatrixXd CrackedOperator::forces_on_boundary(const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const {
  const Eigen::MatrixXd forces = cracks_.constraint.transpose() * opening_forces;
  const Eigen::Index u = stiffness_.rows(), w = full_.rows() - u;
  return forces.topRows(u) - full_.topRightCorner(u, w) * of_openings_.solve(forces.bottomRows(w));
}

Eigen::MatrixXd CrackedOperator::openings(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                                          const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const {
  const Eigen::MatrixXd forces = cracks_.constraint.transpose() * opening_forces;
  const Eigen::Index u = stiffness_.rows(), w = full_.rows() - u;
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
  const Eigen::Index u = stiffness_.rows();
  const Eigen::MatrixXd right =
      rows.topRows(u).transpose() * displacements + rows.bottomRows(rows.rows() - u).transpose() * openings;
  return elasticity_.shear_modulus() / boundary_.length * single_layer_.solve(right);
}

}  // namespace bempd::bem

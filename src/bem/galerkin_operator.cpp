#include "bem/galerkin_operator.hpp"

#include "bem/boundary_elements.hpp"
#include "bem/galerkin_assembly.hpp"
#include "cancellation.hpp"

namespace bempd::bem {

GalerkinOperator::GalerkinOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                                   const AssemblyOptions& options) {
  const ScaledBoundary boundary(mesh);
  std::vector<GalerkinElement> elements = boundary_galerkin_elements(mesh, boundary);
  GalerkinMatrices matrices = assemble_galerkin(elements, static_cast<int>(mesh.nodes.size()), mesh.traction_node_count,
                                                elasticity.effective_poisson_ratio(), options);
  kernel_evaluations_ = matrices.kernel_evaluations;
  single_layer_.compute(std::move(matrices.single_layer));
  check_cancelled();
  require_positive(single_layer_);
  reduced_transpose_ = std::move(matrices.double_layer);
  linalg::solve_upper_from_right(single_layer_.lower(), reduced_transpose_);

  stiffness_ = std::move(matrices.hypersingular);
  linalg::add_square(stiffness_, reduced_transpose_);
  stiffness_ *= elasticity.thickness * elasticity.shear_modulus();
  copy_lower_to_upper(stiffness_);
  traction_scale_ = elasticity.shear_modulus() / boundary.length;
  if (!options.compact) return;
  single_layer_.lower().triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(reduced_transpose_);
  single_layer_ = {};
}

Eigen::MatrixXd GalerkinOperator::tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const {
  Eigen::MatrixXd t = reduced_transpose_.transpose() * displacements;
  if (single_layer_.rows() > 0) single_layer_.matrixU().solveInPlace(t);
  return traction_scale_ * t;
}

}  // namespace bempd::bem

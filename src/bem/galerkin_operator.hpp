#pragma once

#include <cstdint>

#include "bem/boundary_operator.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::bem {

// Symmetric Galerkin boundary element operator of one elastic body: the stiffness K that maps displacements of the
// boundary nodes to nodal forces,
//   K = h G [D + B^T V^-1 B],
// with the single layer V, the Galerkin rows B of the boundary integral equation and the hypersingular operator D, in
// units of the body's diagonal and of the shear modulus (Sirtori 1979; Bonnet, Maier and Polizzotto, Appl. Mech. Rev.
// 51, 1998). D is integrated by parts twice, which leaves only a ln r kernel. h is the thickness, G the shear modulus.
class GalerkinOperator final : public BoundaryOperator {
 public:
  GalerkinOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const AssemblyOptions& options = {});

  // Stiffness, symmetric positive semidefinite; only rigid motions are free of forces.
  const Eigen::MatrixXd& stiffness() const override { return stiffness_; }
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const override;
  std::int64_t kernel_evaluations() const override { return kernel_evaluations_; }

 private:
  Eigen::MatrixXd stiffness_;
  linalg::DenseCholesky single_layer_;  // empty if compact
  Eigen::MatrixXd reduced_transpose_;   // (L^-1 B)^T, V = L L^T, or (V^-1 B)^T if compact
  double traction_scale_ = 1;           // shear modulus over length scale
  std::int64_t kernel_evaluations_ = 0;
};

}  // namespace bempd::bem

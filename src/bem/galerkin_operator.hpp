#pragma once

#include <Eigen/Cholesky>
#include <cstdint>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

struct AssemblyOptions {
  double quadrature_tolerance = 1e-14;  // relative error of every pair of elements
  int threads = 0;                      // 0: OpenMP's default
};

// Symmetric Galerkin boundary element operator of one elastic body: displacements of the boundary nodes to nodal
// forces,
//   K = h G [D + B^T V^-1 B],
// with the single layer V, the Galerkin rows B of the boundary integral equation and the hypersingular operator D, in
// lengths over the body's diagonal and stresses over the shear modulus (Sirtori 1979; Bonnet, Maier and Polizzotto,
// Appl. Mech. Rev. 51, 1998). D is integrated by parts twice, so that only ln r is left of it.
class GalerkinOperator {
 public:
  GalerkinOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const AssemblyOptions& options = {});

  // [N/m], thickness included; degree of freedom 2 * node + component. Symmetric positive semidefinite; the only
  // motions without force are the rigid ones.
  const Eigen::MatrixXd& stiffness() const { return stiffness_; }

  // Boundary tractions [Pa], row 2 * traction_node + component, one column per column of displacements [m].
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const;

  std::int64_t kernel_evaluations() const { return kernel_evaluations_; }

 private:
  Eigen::MatrixXd stiffness_;
  Eigen::LLT<Eigen::MatrixXd> single_layer_;
  Eigen::MatrixXd reduced_transpose_;  // (L^-1 B)^T, V = L L^T
  double traction_scale_ = 1;          // shear modulus over length scale
  std::int64_t kernel_evaluations_ = 0;
};

}  // namespace bempd::bem

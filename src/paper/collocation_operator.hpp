#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "bem/boundary_operator.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"

namespace bempd::paper {

// Copy of a mesh in which the displacement nodes are the traction nodes, too: a corner has one traction, which cannot
// jump.
BoundaryMesh with_one_traction_at_corners(BoundaryMesh mesh);

// Collocation boundary element operator of one elastic body with quadratic elements. Somigliana's identity H u = G t
// between displacements u and tractions t, at as many points as there are traction nodes, is solved for t = K_B u, K_B
// = G^-1 H (Yang and Liu, Int. J. Solids Struct. 2021, Eqs. 4 and 7). The consistent nodal forces h M K_B u give the
// stiffness, with the thickness h and the integrals M of products of shape functions. Collocation points are the nodes;
// a node with two tractions has a point inside each of its elements instead. The stiffness is not symmetric. Its
// symmetric part alone would be no approximation, because it is wrong for constant strains.
class CollocationOperator final : public bem::BoundaryOperator {
 public:
  CollocationOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                      const bem::AssemblyOptions& options = {});

  const Eigen::MatrixXd& stiffness() const override { return stiffness_; }
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const override;
  std::int64_t kernel_evaluations() const override { return kernel_evaluations_; }

  // Matrix K_B [Pa/m] that gives tractions from displacements: rows 2 * traction_node + component, columns 2 * node +
  // component.
  const Eigen::MatrixXd& traction_matrix() const { return traction_matrix_; }

 private:
  Eigen::MatrixXd traction_matrix_, stiffness_;
  std::int64_t kernel_evaluations_ = 0;
};

}  // namespace bempd::paper

#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <vector>

#include "bem/boundary_operator.hpp"
#include "bem/crack_mesh.hpp"
#include "bem/galerkin_assembly.hpp"
#include "bem/kept_blocks.hpp"
#include "bem/opening_elimination.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::bem {

// Galerkin operator of a body with cracks. Openings are further unknowns beside the displacements u of the boundary:
//   K = h G [D + B^T V^-1 B]  on (u, w),
// V being that of the body without cracks, D and B having columns for openings, integrated as those of the boundary;
// the force that belongs to an opening is the traction on its left face (Bonnet, Maier and Polizzotto, Appl. Mech. Rev.
// 51, 1998, section 6). All that other bodies see of it is the stiffness of the boundary's nodes, the openings being
// eliminated.
class CrackedOperator final : public BoundaryOperator {
 public:
  // The mesh with its nodes split at mouths, and with the faces of cracks between pieces. What a body `before` with
  // shorter cracks has in common is taken over from it: integrals, the factor of V, and products with that.
  CrackedOperator(const BoundaryMesh& mesh, const CrackMesh& cracks, const PlaneElasticity& elasticity,
                  const AssemblyOptions& options = {}, const CrackedOperator* before = nullptr);

  // Symmetric positive semidefinite, of the boundary's nodes.
  const Eigen::MatrixXd& stiffness() const override { return of_openings_.stiffness(); }
  // With faces free of traction.
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const override;
  std::int64_t kernel_evaluations() const override { return kernel_evaluations_; }

  // Of displacements and remaining openings.
  const Eigen::MatrixXd& full_stiffness() const { return full_; }

  // Forces on all openings [N], as crack_forces.hpp gives them, as forces on the boundary's nodes: what they add to the
  // right-hand side.
  Eigen::MatrixXd forces_on_boundary(const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const;
  // Openings that remain from forces on them, the displacements held.
  Eigen::MatrixXd opening_response(const Eigen::Ref<const Eigen::MatrixXd>& forces) const {
    return of_openings_.solve(forces);
  }
  // All openings [m] that belong to displacements and such forces.
  Eigen::MatrixXd openings(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                           const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const;
  // Tractions [Pa] of the boundary with all openings.
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                            const Eigen::Ref<const Eigen::MatrixXd>& openings) const;

  const std::vector<GalerkinElement>& elements() const { return elements_; }
  // V, D and B^T of all displacements and openings, as integrated; V and D whole.
  const GalerkinMatrices& matrices() const { return matrices_; }
  const CrackMesh& cracks() const { return cracks_; }
  const BoundaryMesh& mesh() const { return mesh_; }
  const ScaledBoundary& boundary() const { return boundary_; }
  const PlaneElasticity& elasticity() const { return elasticity_; }
  const AssemblyOptions& options() const { return options_; }

 private:
  void take_from(const CrackedOperator& before, const KeptNodes& kept);

  BoundaryMesh mesh_;
  CrackMesh cracks_;
  PlaneElasticity elasticity_;
  AssemblyOptions options_;
  ScaledBoundary boundary_;
  std::vector<GalerkinElement> elements_;
  GalerkinMatrices matrices_;
  std::shared_ptr<const linalg::DenseCholesky> single_layer_;
  // Of all displacements and openings, L L^T being V: L^-1 B, and D + B^T V^-1 B. Empty unless cracks have grown.
  Eigen::MatrixXd reduced_, raw_;
  Eigen::MatrixXd full_;
  OpeningElimination of_openings_;
  std::int64_t kernel_evaluations_ = 0;
};

// The elements of the boundary, and behind them those of its cracks.
std::vector<GalerkinElement> cracked_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary,
                                                       const CrackMesh& cracks);

// Adds B^T V^-1 B to the lower triangle of D, and makes the sum whole; `double_layer` is B^T.
void add_forces_of_tractions(Eigen::MatrixXd double_layer, const linalg::DenseCholesky& single_layer,
                             Eigen::MatrixXd& stiffness);

// Displacements and all openings, one below the other, from the unknowns.
Eigen::SparseMatrix<double> from_unknowns(const BoundaryMesh& mesh, const CrackMesh& cracks);

// map^T a, of a map with an entry or a few in every column.
Eigen::MatrixXd transposed_product(const Eigen::SparseMatrix<double>& map, const Eigen::MatrixXd& a);

// The lower triangle of map^T a map, a being symmetric and whole.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::SparseMatrix<double>& map);

}  // namespace bempd::bem

#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <vector>

#include "bem/boundary_operator.hpp"
#include "bem/crack_mesh.hpp"
#include "bem/galerkin_assembly.hpp"
#include "bem/kept_blocks.hpp"
#include "bem/opening_schur_complement.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::bem {

// Galerkin operator of a body with cracks. The openings w are unknowns beside the displacements u of the boundary:
//   K = h G [D + B^T V^-1 B]  on (u, w),
// with the thickness h and the shear modulus G. The single layer V is that of the body without cracks. The
// hypersingular matrix D and the double layer B have further columns for openings, integrated like those of the
// boundary. The force conjugate to an opening is the traction on the left face (Bonnet, Maier and Polizzotto, Appl.
// Mech. Rev. 51, 1998, section 6). Other parts of the scene use only the stiffness of the boundary nodes, from which
// the openings are eliminated.
class CrackedOperator final : public BoundaryOperator {
 public:
  // Builds the operator on a boundary mesh whose nodes are split at crack mouths, and which contains both faces of the
  // crack lines that cut the body into pieces. `before` is the operator of the body with shorter cracks (null: none).
  // Integrals, the factor of V and products with this factor are copied from `before` where both bodies are the same.
  CrackedOperator(const BoundaryMesh& mesh, const CrackMesh& cracks, const PlaneElasticity& elasticity,
                  const AssemblyOptions& options = {}, const CrackedOperator* before = nullptr);

  // Stiffness of the boundary's nodes, symmetric positive semidefinite.
  const Eigen::MatrixXd& stiffness() const override { return of_openings_.stiffness(); }
  // Boundary tractions [Pa] from displacements of the boundary nodes, with no tractions on the crack faces.
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const override;
  std::int64_t kernel_evaluations() const override { return kernel_evaluations_; }

  // Stiffness on the displacements of the boundary nodes and the free openings.
  const Eigen::MatrixXd& full_stiffness() const { return full_; }

  // Forces on the boundary nodes that have the same effect on displacements as forces [N] on all openings
  // (crack_forces.hpp): the part of the right-hand side that remains after the openings are eliminated.
  Eigen::MatrixXd forces_on_boundary(const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const;
  // Free openings that `forces`, acting on the free openings, cause while the displacements are held at zero.
  Eigen::MatrixXd opening_response(const Eigen::Ref<const Eigen::MatrixXd>& forces) const {
    return of_openings_.solve(forces);
  }
  // All openings [m] from displacements of the boundary nodes and forces on all openings.
  Eigen::MatrixXd openings(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                           const Eigen::Ref<const Eigen::MatrixXd>& opening_forces) const;
  // Boundary tractions [Pa] from displacements of the boundary nodes and all openings.
  Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements,
                            const Eigen::Ref<const Eigen::MatrixXd>& openings) const;

  const std::vector<GalerkinElement>& elements() const { return elements_; }
  // Galerkin matrices V, D and B^T on all displacements and openings, before constraints; both triangles of V and D.
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
  // Products L^-1 B and D + B^T V^-1 B of the Galerkin matrices, with L L^T = V, on all displacements and openings;
  // empty unless cracks have grown.
  Eigen::MatrixXd reduced_, raw_;
  Eigen::MatrixXd full_;
  OpeningSchurComplement of_openings_;
  std::int64_t kernel_evaluations_ = 0;
};

// Galerkin elements of the boundary, followed by those of the cracks.
std::vector<GalerkinElement> cracked_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary,
                                                       const CrackMesh& cracks);

// Adds B^T V^-1 B to the lower triangle of `stiffness` and copies the sum to the upper triangle. `double_layer` is B^T,
// `single_layer` the Cholesky factor of V.
void add_forces_of_tractions(Eigen::MatrixXd double_layer, const linalg::DenseCholesky& single_layer,
                             Eigen::MatrixXd& stiffness);

// Matrix that gives the displacements of all boundary nodes, then all openings, from the unknowns.
Eigen::SparseMatrix<double> from_unknowns(const BoundaryMesh& mesh, const CrackMesh& cracks);

// Product map^T a, for a map with few entries in every column.
Eigen::MatrixXd transposed_product(const Eigen::SparseMatrix<double>& map, const Eigen::MatrixXd& a);

// Lower triangle of map^T a map, where both triangles of the symmetric a are given.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::SparseMatrix<double>& map);

}  // namespace bempd::bem

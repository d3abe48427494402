#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>
#include <vector>

#include "bem/boundary_elements.hpp"
#include "bem/boundary_operator.hpp"

namespace bempd::bem {

// Element of the boundary or of a crack. The nodes of a crack element are opening nodes, and it has no traction nodes.
struct GalerkinElement {
  ElementGeometry geometry;
  std::array<int, 3> nodes;
  std::array<int, 3> traction_nodes;
  // Position numbers of the element's ends. Elements with a common position touch, even without a common node.
  std::array<int, 2> places;
  bool crack = false;
  int piece = 0;  // piece of the body; elements of different pieces have no integrals with each other
};

std::vector<GalerkinElement> boundary_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary);

struct GalerkinMatrices {
  Eigen::MatrixXd single_layer;   // V, lower triangle
  Eigen::MatrixXd hypersingular;  // D, lower triangle
  Eigen::MatrixXd double_layer;   // B^T
  std::int64_t kernel_evaluations = 0;
};

// Matrices of another body with blocks that can be copied (kept_blocks.hpp).
struct KnownBlocks;

// Assembles the Galerkin matrices of a body over the elements of its boundary, followed by those of its cracks. Cracks
// have no traction nodes, so they have columns in the double layer and the hypersingular matrix only. Blocks in
// `known`, which belong to another body, are copied (null: none).
GalerkinMatrices assemble_galerkin(const std::vector<GalerkinElement>& elements, int nodes, int traction_nodes,
                                   double nu, const AssemblyOptions& options, const KnownBlocks* known = nullptr);

// Throws Error (unsolvable) if the Cholesky factorization of the single layer has failed.
void require_positive(const Eigen::LLT<Eigen::MatrixXd>& single_layer);

void copy_lower_to_upper(Eigen::MatrixXd& a);

}  // namespace bempd::bem

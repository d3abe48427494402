#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>
#include <vector>

#include "bem/boundary_elements.hpp"
#include "bem/boundary_operator.hpp"

namespace bempd::bem {

// Element of the boundary or of a crack. A crack element's nodes are those of openings, and it has no tractions.
struct GalerkinElement {
  ElementGeometry geometry;
  std::array<int, 3> nodes;
  std::array<int, 3> traction_nodes;
  std::array<int, 2> places;  // numbers of its ends: elements with a common one touch, even without a common node
  bool crack = false;
  int piece = 0;  // piece of a body that cracks cut: elements of different pieces have no integrals with each other
};

std::vector<GalerkinElement> boundary_galerkin_elements(const BoundaryMesh& mesh, const ScaledBoundary& boundary);

struct GalerkinMatrices {
  Eigen::MatrixXd single_layer;   // V, lower triangle
  Eigen::MatrixXd hypersingular;  // D, lower triangle
  Eigen::MatrixXd double_layer;   // B^T
  std::int64_t kernel_evaluations = 0;
};

// The Galerkin matrices of a body over the elements of its boundary, and of its cracks behind them; a crack has no
// traction, so it has columns in B and D only.
struct KnownBlocks;

// Assembles the matrices; blocks that are known from another body are copied (kept_blocks.hpp).
GalerkinMatrices assemble_galerkin(const std::vector<GalerkinElement>& elements, int nodes, int traction_nodes,
                                   double nu, const AssemblyOptions& options, const KnownBlocks* known = nullptr);

// Throws Error (unsolvable) unless the single layer has a Cholesky factor.
void require_positive(const Eigen::LLT<Eigen::MatrixXd>& single_layer);

void copy_lower_to_upper(Eigen::MatrixXd& a);

}  // namespace bempd::bem

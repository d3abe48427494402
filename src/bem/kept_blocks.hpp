#pragma once

#include <vector>

#include "bem/galerkin_assembly.hpp"

namespace bempd::bem {

// Nodes that a body has in common with the body before its cracks changed. All elements around such a node are the same
// in both, and so are the node's blocks in the matrices.
struct KeptNodes {
  std::vector<int> nodes, traction_nodes;    // nodes of the other body, by node; -1 for new ones
  bool whole_boundary = false;               // with its traction nodes in their order
  int boundary_nodes = 0;                    // of `nodes`, the first ones
  std::vector<int> pieces, traction_pieces;  // piece of the body that each node lies on

  bool has(const GalerkinElement& element) const;
  // Whether the integrals over a pair of elements are known. Rows of B on boundary nodes are known only if the whole
  // boundary is the same, because the term that removes the forces of rigid motions is a sum over all of it.
  bool has(const GalerkinElement& outer, const GalerkinElement& inner) const {
    return has(outer) && has(inner) && (whole_boundary || outer.crack || inner.crack);
  }
  bool has_block(int a, int b) const { return nodes[a] >= 0 && nodes[b] >= 0; }
  bool has_traction_block(int a, int b) const { return traction_nodes[a] >= 0 && traction_nodes[b] >= 0; }
  bool has_mixed_block(int node, int traction) const {
    return nodes[node] >= 0 && traction_nodes[traction] >= 0 && (whole_boundary || node >= boundary_nodes);
  }
};

KeptNodes kept_nodes(const std::vector<GalerkinElement>& before, const std::vector<GalerkinElement>& elements,
                     int boundary_nodes, int nodes, int traction_nodes);

// Matrices of the other body, from which blocks are copied; D has both triangles.
struct KnownBlocks {
  const KeptNodes& kept;
  const GalerkinMatrices& matrices;
};

// Copies all blocks between kept nodes into `matrices`.
void copy_kept(const KnownBlocks& known, GalerkinMatrices& matrices);

// Copies the columns, or the blocks (rows and columns), of kept nodes, which have two components each. `kept` gives the
// node in `from` for each node in `to`, or -1.
void copy_kept_columns(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to);
void copy_kept_blocks(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to);

}  // namespace bempd::bem

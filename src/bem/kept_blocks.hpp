#pragma once

#include <vector>

#include "bem/galerkin_assembly.hpp"

namespace bempd::bem {

// Nodes that a body has in common with the earlier body (the same body before its cracks changed). All elements around
// such a node are the same in both bodies, and so are the node's blocks in the matrices.
struct KeptNodes {
  std::vector<int> nodes, traction_nodes;    // number of each node in the earlier body; -1 for new nodes
  bool whole_boundary = false;               // whether all boundary elements and their traction nodes are the same
  int boundary_nodes = 0;                    // number of boundary nodes, which come first in `nodes`
  std::vector<int> pieces, traction_pieces;  // piece of the body on which each node lies

  bool has(const GalerkinElement& element) const;
  // Whether the integrals over a pair of elements are known. Rows of the double layer on boundary nodes are known only
  // if the whole boundary is the same, because the term that removes the forces of rigid motions is a sum over the
  // whole boundary.
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

// Matrices of the earlier body (the body before its cracks changed), from which blocks are copied. The hypersingular
// matrix has both triangles.
struct KnownBlocks {
  const KeptNodes& kept;
  const GalerkinMatrices& matrices;
};

// Copies into `matrices` all blocks between kept nodes of the same piece of the body.
void copy_kept(const KnownBlocks& known, GalerkinMatrices& matrices);

// Copies the columns of kept nodes, or the blocks (rows and columns) between kept nodes, with two components per node.
// `kept` gives for each node in `to` its number in `from`, or -1.
void copy_kept_columns(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to);
void copy_kept_blocks(const std::vector<int>& kept, const Eigen::MatrixXd& from, Eigen::MatrixXd& to);

}  // namespace bempd::bem

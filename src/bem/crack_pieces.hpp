#pragma once

#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

// End of a crack line at a joint; `end` is 0 for the start of the line.
struct LineEnd {
  int line, end;
};

// Pieces into which cracks cut a body.
struct CrackPieces {
  int count = 1;
  std::vector<int> of_element;  // piece of each boundary element, crack faces included; empty if there is one piece
  std::vector<std::array<int, 2>> of_line;  // pieces on the left and right of each line; empty if there is one
  // Ends of crack lines at each joint, counter-clockwise. At a crack mouth they are ordered from the boundary that
  // starts at the mouth to the boundary that ends at it.
  std::vector<std::vector<LineEnd>> around;

  bool is_cut(int line) const { return count > 1 && of_line[line][0] != of_line[line][1]; }
  int left_of(int line) const { return count > 1 ? of_line[line][0] : 0; }
  int right_of(int line) const { return count > 1 ? of_line[line][1] : 0; }
};

// Boundary elements of one piece, as a mesh with the nodes of the whole mesh.
BoundaryMesh elements_of_piece(const BoundaryMesh& mesh, const CrackPieces& pieces, int piece);

// Finds the pieces into which cracks cut a body. The nodes of `mesh` are split at crack mouths: `mouth_of_joint` has
// the nodes before and behind each joint's mouth, -1 for joints inside the body. The first loop of the mesh is the
// outer loop.
CrackPieces find_pieces(const CrackLines& cracks, const BoundaryMesh& mesh,
                        const std::vector<std::array<int, 2>>& mouth_of_joint);

}  // namespace bempd::bem

#pragma once

#include <array>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

// An end of a crack's line, seen from the joint where it lies: 0 for the line's start.
struct LineEnd {
  int line, end;
};

// The pieces into which cracks cut a body.
struct CrackPieces {
  int count = 1;
  std::vector<int> of_element;              // of the boundary, with the faces that cracks add; empty for one piece
  std::vector<std::array<int, 2>> of_line;  // on its left and on its right; empty for one piece
  // Lines that end at each joint, counter-clockwise; at a mouth they are in order from the boundary that starts there
  // to the boundary that ends there.
  std::vector<std::vector<LineEnd>> around;

  bool is_cut(int line) const { return count > 1 && of_line[line][0] != of_line[line][1]; }
  int left_of(int line) const { return count > 1 ? of_line[line][0] : 0; }
  int right_of(int line) const { return count > 1 ? of_line[line][1] : 0; }
};

// Boundary elements of one piece, with all nodes of the mesh.
BoundaryMesh elements_of_piece(const BoundaryMesh& mesh, const CrackPieces& pieces, int piece);

// `mesh` has its nodes split at mouths: those before and behind it of every joint, -1 inside the body. The first loop
// of the mesh is the outer one.
CrackPieces find_pieces(const CrackLines& cracks, const BoundaryMesh& mesh,
                        const std::vector<std::array<int, 2>>& mouth_of_joint);

}  // namespace bempd::bem

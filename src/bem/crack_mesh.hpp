#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "bem/crack_pieces.hpp"
#include "bem/element_geometry.hpp"
#include "geometry/boundary_mesh.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

struct CrackElement {
  std::array<int, 3> nodes;  // of the openings: start, mid, end
  int line;
  double from, to;  // ways along its line
  TipEnd tip = TipEnd::none;
  int piece = 0;
};

// Element of a line between two pieces of a body. Its faces are parts of the pieces' boundaries, so that its opening is
// the difference of their displacements.
struct CutElement {
  int line;
  double from, to;                 // ways along its line
  std::array<int, 3> left, right;  // boundary nodes of each face, in the direction of the line
};

struct CrackTip {
  int element, line;
  TipEnd end;              // of the element, and of the line
  Point place, direction;  // the unit vector that leads on
};

// Elements on cracks. Their unknowns are the openings w = u_left - u_right, with left and right as seen along the line;
// the outward normal of the left face points to the right. Every line has nodes of its own; `constraint` relates the
// openings at joints and tips.
struct CrackMesh {
  std::vector<Point> nodes;
  std::vector<CrackElement> elements;
  std::vector<CutElement> cuts;
  std::vector<CrackTip> tips;
  std::vector<int> joint_of_node;  // -1 for most
  // Boundary nodes before and behind the mouth at each joint, in the direction of the boundary's loop; -1: no mouth
  // there.
  std::vector<std::array<int, 2>> mouth_of_joint;

  // Matrix that gives all openings from the unknowns, which are the displacements of the boundary nodes and then the
  // free openings. Openings are 0 at tips. Around a joint their sum is 0; at a mouth it is the displacement before the
  // mouth less the one behind it.
  Eigen::SparseMatrix<double> constraint;
  int free_nodes = 0;  // openings that remain

  CrackPieces pieces;
  std::vector<std::vector<int>> nodes_at_joint;  // boundary nodes
  int first_face_panel = 0;                      // first panel on a face; these are the last panels
};

// Meshes the cracks, with elements that end at `stations` along each line, and splits the nodes of `mesh` at mouths:
// new nodes come at the end of its list. Faces of lines that cut the body are added to `mesh` as boundary elements
// behind all others, with a panel for each straight part.
CrackMesh mesh_cracks(const CrackLines& cracks, const std::vector<std::vector<double>>& stations, BoundaryMesh& mesh,
                      double tolerance);

}  // namespace bempd::bem

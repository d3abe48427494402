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
  std::array<int, 3> nodes;  // opening nodes: start, mid, end
  int line;
  double from, to;  // distances of its ends along its line
  TipEnd tip = TipEnd::none;
  int piece = 0;  // piece of the body in which the element lies
};

// Element of a crack line that separates two pieces of a body. Each face is a part of a piece's boundary, so that the
// opening is the difference of the displacements of the two faces.
struct CutElement {
  int line;
  double from, to;                 // distances of its ends along its line
  std::array<int, 3> left, right;  // boundary nodes of each face, in the direction of the line
};

struct CrackTip {
  int element, line;
  TipEnd end;              // end of the element, and of the line, that is the tip
  Point place, direction;  // place of the tip, and unit vector of straight growth
};

// Elements on cracks. Their unknowns are the openings w = u_left - u_right, with left and right as seen along the crack
// line; the outward normal of the left face points to the right. Every line has opening nodes of its own; `constraint`
// relates the openings at joints and tips.
struct CrackMesh {
  std::vector<Point> nodes;
  std::vector<CrackElement> elements;
  std::vector<CutElement> cuts;
  std::vector<CrackTip> tips;
  std::vector<int> joint_of_node;  // joint at each opening node; -1: none
  // Boundary nodes before and behind the mouth (where a crack meets the boundary) at each joint, in the direction of
  // the boundary's loop; -1 if the joint is no mouth.
  std::vector<std::array<int, 2>> mouth_of_joint;

  // Matrix that gives all openings from the unknowns, which are the displacements of the boundary nodes, followed by
  // the free openings. Openings are 0 at tips. The openings around a joint, with the signs of the lines' directions,
  // add to 0; at a mouth they add to the displacement before the mouth less the displacement behind it. Where pieces of
  // the body meet at a joint, each opening is the difference of the displacements on both sides of its line.
  Eigen::SparseMatrix<double> constraint;
  int free_nodes = 0;  // number of opening nodes with free openings

  CrackPieces pieces;
  std::vector<std::vector<int>> nodes_at_joint;  // boundary nodes at each joint
  int first_face_panel = 0;                      // panels from this one on lie on crack faces
};

// Meshes the cracks, with elements that end at `stations` along each crack line, and splits the nodes of `mesh` at
// crack mouths; new nodes are appended to its list. Faces of lines that cut the body are added to `mesh` as boundary
// elements behind all others, with a panel for each straight part.
CrackMesh mesh_cracks(const CrackLines& cracks, const std::vector<std::vector<double>>& stations, BoundaryMesh& mesh,
                      double tolerance);

}  // namespace bempd::bem

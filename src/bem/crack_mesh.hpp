#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "bem/element_geometry.hpp"
#include "geometry/boundary_mesh.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

struct CrackElement {
  std::array<int, 3> nodes;  // of the openings: start, mid, end
  int line;
  double from, to;  // ways along its line
  TipEnd tip = TipEnd::none;
};

struct CrackTip {
  int element, line;
  TipEnd end;              // of the element, and of the line
  Point place, direction;  // the unit vector that leads on
};

// Elements on cracks. Their unknowns are the openings w = u_left - u_right, seen along the line; its left face has the
// outward normal that points to the right. Every line has nodes of its own; what holds between them at joints and tips
// says `constraint`.
struct CrackMesh {
  std::vector<Point> nodes;
  std::vector<CrackElement> elements;
  std::vector<CrackTip> tips;
  std::vector<int> joint_of_node;  // -1 for most
  // The boundary's nodes before and behind it, in the direction of its loop; -1: no mouth.
  std::vector<std::array<int, 2>> mouth_of_joint;

  // All openings from the unknowns: displacements of the boundary's nodes, then the openings that remain. There are
  // none at tips; around a joint openings add to nothing or, at a mouth, to the displacement before it less the one
  // behind it.
  Eigen::SparseMatrix<double> constraint;
  int free_nodes = 0;  // openings that remain
};

// Splits the boundary's nodes at mouths: a node more for the elements that start there, at the end of the list.
CrackMesh mesh_cracks(const CrackLines& cracks, const std::vector<std::vector<double>>& stations, BoundaryMesh& mesh,
                      double tolerance);

}  // namespace bempd::bem

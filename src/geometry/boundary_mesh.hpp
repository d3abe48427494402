#pragma once

#include <array>
#include <vector>

#include "geometry/arc.hpp"

namespace bempd {

// Boundary element with three nodes (start, mid, end), directed so that the body lies on its left.
struct BoundaryElement {
  std::array<int, 3> nodes;           // displacement nodes
  std::array<int, 3> traction_nodes;  // traction nodes; neighbouring elements of a panel share one
  int panel = 0;                      // number of its panel
  double sweep = 0;                   // angle by which the tangent turns along the element; 0: straight
};

// Panel: a straight piece or circular arc of a boundary between two places where the traction may jump, such as corners
// and ends of loads, supports and interfaces. `stations` are the ends of the panel's elements, as fractions of its
// length, 0 = first < ... < last = 1.
struct Panel {
  Point start, end;
  std::vector<double> stations;
  double sweep = 0;  // angle by which the tangent turns along the panel, counter-clockwise positive

  Arc arc() const { return {start, end, sweep}; }
};

// Mesh of the closed boundary of one body: the outer loop counter-clockwise, holes clockwise; each panel begins where
// the previous panel ends. Neighbouring elements of a loop share displacement nodes. Tractions are continuous inside a
// panel and have traction nodes of their own at its ends, so that they may jump there.
struct BoundaryMesh {
  std::vector<Point> nodes;
  std::vector<BoundaryElement> elements;
  int traction_node_count = 0;
};

// Makes the boundary mesh; `loops[l]` has the panels of loop l in order. Panels are numbered through all loops.
BoundaryMesh mesh_boundary(const std::vector<std::vector<Panel>>& loops);

// Whether two meshes have the same elements, with positions that differ by one translation up to rounding.
bool differ_by_translation(const BoundaryMesh& a, const BoundaryMesh& b);

// Largest angle by which the tangent may turn along an element: a full circle has at least eight elements.
inline constexpr double largest_element_sweep = 0.7853981633974483;  // pi / 4

// Ends of elements, as fractions, for a piece of the given length and sweep, with elements no longer than about
// `target`. The elements are equal if `grading` is 1; otherwise their lengths grow from both ends, each by the factor
// `grading` >= 1.
std::vector<double> element_stations(double length, double target, double grading = 1.0, double sweep = 0.0);

}  // namespace bempd

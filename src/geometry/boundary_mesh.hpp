#pragma once

#include <array>
#include <vector>

#include "geometry/arc.hpp"

namespace bempd {

// Element with three nodes (start, mid, end) in the direction that has the body on its left.
struct BoundaryElement {
  std::array<int, 3> nodes;           // displacement nodes
  std::array<int, 3> traction_nodes;  // traction nodes; neighbours share one inside a panel
  int panel = 0;                      // index of the panel it came from
  double sweep = 0;                   // angle by which the tangent turns along it; 0 if it is straight
};

// Straight piece or circular arc of a boundary between two places where the traction may jump: corners, ends of loads,
// supports and interfaces. `stations` are the element ends as fractions of the length, 0 = first < ... < last = 1.
struct Panel {
  Point start, end;
  std::vector<double> stations;
  double sweep = 0;  // angle by which the tangent turns along it, counter-clockwise positive

  Arc arc() const { return {start, end, sweep}; }
};

// Closed boundary of one body: the outer loop counter-clockwise, holes clockwise, every panel continuing the last one.
// Displacement nodes are shared along each loop. The traction space is continuous inside a panel and has two nodes at
// its ends, so that tractions may jump there.
struct BoundaryMesh {
  std::vector<Point> nodes;
  std::vector<BoundaryElement> elements;
  int traction_node_count = 0;
};

// `loops[l]` lists the panels of loop l in order; panels are numbered through all loops.
BoundaryMesh mesh_boundary(const std::vector<std::vector<Panel>>& loops);

// Whether two meshes have the same elements on places that differ by a translation, up to the rounding of the places.
bool differ_by_translation(const BoundaryMesh& a, const BoundaryMesh& b);

// Largest angle by which an element may turn: eight elements for a full circle.
inline constexpr double largest_element_sweep = 0.7853981633974483;  // pi / 4

// Element ends for a piece of the given length and sweep: `count = ceil(length / target)` equal elements when `grading`
// is 1; otherwise the lengths of neighbours differ by the factor `grading` >= 1, growing from both ends.
std::vector<double> element_stations(double length, double target, double grading = 1.0, double sweep = 0.0);

}  // namespace bempd

#pragma once

#include "geometry/outline.hpp"

namespace bempd {

enum class OutlineDefect {
  none,
  not_finite,         // a coordinate is not a finite number, or beyond 1e75; edge_a is the vertex
  too_few_vertices,   // no loop at all, or a loop with fewer than three vertices
  repeated_vertex,    // edge_a has no length, because its vertex is given twice in a row
  spike,              // edge_b runs back over edge_a
  self_crossing,      // edge_a and edge_b of one loop cross or touch
  wrong_orientation,  // outer loop clockwise, or hole counter-clockwise
  hole_outside,       // a hole leaves or touches the outer loop, edge_a and edge_b say where if it does; -1 if it lies
                      // wholly outside
  holes_overlap       // two holes cross or touch (edge_a, edge_b) or one lies in the other (-1)
};

// Result of check_outline(): the first defect found. `loop` is the loop at fault (if there are two, the later one).
// Edges are numbered through all loops, and edge k starts at vertex k; -1 means no edge.
struct OutlineCheck {
  OutlineDefect defect = OutlineDefect::none;
  int loop = -1;
  int edge_a = -1, edge_b = -1;
  Point where = Point::Zero();

  bool sound() const { return defect == OutlineDefect::none; }
};

OutlineCheck check_outline(const Outline& outline);

}  // namespace bempd

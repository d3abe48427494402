#pragma once

#include <array>
#include <vector>

#include "geometry/crack_lines.hpp"
#include "geometry/edge.hpp"

namespace bempd {

// Triangulation of the inside of a body, for pictures. Triangles have about the same size, smaller where the outline or
// cracks require it. Cracks run along sides of triangles.
struct BodyMesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
  std::vector<std::array<int, 2>> crack_sides;
};

// Triangulates the inside of a body. `boundary` has all edges of all loops in order; `size` is the length of a
// triangle's side.
BodyMesh mesh_body(const std::vector<Edge>& boundary, const CrackLines& cracks, double size);

}  // namespace bempd

#pragma once

#include <array>
#include <vector>

#include "geometry/crack_lines.hpp"
#include "geometry/edge.hpp"

namespace bempd {

// The inside of a body as triangles, for pictures: of about one size, smaller where the outline and the cracks ask for
// it. Cracks are sides of triangles.
struct BodyMesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
  std::vector<std::array<int, 2>> crack_sides;
};

// `boundary` holds the edges of all loops in order; `size` is the length of a side.
BodyMesh mesh_body(const std::vector<Edge>& boundary, const CrackLines& cracks, double size);

}  // namespace bempd

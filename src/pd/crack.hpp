#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// What happens to bonds that touch a crack without crossing it.
enum class Touching {
  // They are cut, whatever touches.
  cuts,
  // They are cut, unless it is their own end that lies on the crack: then only a crack that also meets the bond between
  // its ends, other than along it, cuts. Points on the crack stay bonded to both faces and bridge it.
  of_ends_keeps
};

// Cracks are polylines in lattice coordinates, like the points. A bond is cut if it meets the closed polyline.
// Distances up to 1e-9 count as touching.
std::vector<int> bonds_cut_by(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                              const std::vector<Point>& vertices, Touching touching = Touching::cuts);

// Material points on the polyline. They would hold on to neither face of the crack.
std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices);

}  // namespace bempd::pd

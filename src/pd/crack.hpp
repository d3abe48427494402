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

// How a crack ends so that its tip is felt at a place.
struct FeltEnd {
  Point end;
  std::vector<int> weakened;  // bonds that meet no crack and have a share of their stiffness only
  double share = 1;
};

// Of a crack that comes straight to its tip in this direction. What is felt is how much stiffness across its line is
// gone: the tip is felt felt_ahead_of_cut() ahead of where cut bonds, evenly spread, would take as much of it as those
// do that are cut. So bonds are counted by their stiffness across the line, and the last of them, those of one place,
// keep the share that makes it even. The end is at most a spacing and a half from the tip, and `backward` behind it; it
// is the tip where there are too few bonds to tell. (docs/verification.md)
FeltEnd end_felt_at(const std::vector<Point>& points, const std::vector<Bond>& bonds, const Point& tip,
                    const Point& direction, int horizon_ratio, double backward);

// In spacings; measured for horizons of 3 to 6 spacings, 0.02 to 0.03 of scatter over directions and places.
inline double felt_ahead_of_cut(int horizon_ratio) { return 0.05 * (horizon_ratio + 1); }

// Material points on the polyline. They would hold on to neither face of the crack.
std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices);

}  // namespace bempd::pd

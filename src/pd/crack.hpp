#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Rule for bonds that touch a crack without crossing it.
enum class Touching {
  // The crack cuts all bonds that touch it.
  cuts,
  // The crack cuts bonds that touch it, except those whose own end lies on it: such a bond is cut only if the crack
  // also meets it between its ends, other than along it. Points on the crack stay bonded to both faces and bridge it.
  of_ends_keeps
};

// Bonds cut by a crack: those that meet its closed polyline. Cracks are polylines in lattice coordinates, like the
// points. Distances up to 1e-9 count as touching.
std::vector<int> bonds_cut_by(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                              const std::vector<Point>& vertices, Touching touching = Touching::cuts);

// End of a cut that puts the effective tip of the crack at a wanted place.
struct FeltEnd {
  Point end;
  std::vector<int> weakened;  // bonds that meet no crack and have a share of their stiffness only
  double share = 1;
};

// End of the cut for a crack that comes straight to its tip in this direction. The effective tip depends on how much
// stiffness across the crack's line is lost: it lies felt_ahead_of_cut() ahead of where evenly spread cut bonds would
// take as much of it as the cut bonds do. So bonds are counted by their stiffness across the line, and the last of
// them, those of one place, keep a share that makes the loss even. The end is at most a spacing and a half from the
// tip, and `backward` behind it; it is the tip where there are too few bonds to tell. (docs/verification.md)
FeltEnd end_felt_at(const std::vector<Point>& points, const std::vector<Bond>& bonds, const Point& tip,
                    const Point& direction, int horizon_ratio, double backward);

// Distance of the effective tip ahead of the cut, in spacings; measured for horizons of 3 to 6 spacings, with a scatter
// of 0.02 to 0.03 over directions and places.
inline double felt_ahead_of_cut(int horizon_ratio) { return 0.05 * (horizon_ratio + 1); }

// Material points on the polyline, which would be bonded to neither face of the crack.
std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices);

}  // namespace bempd::pd

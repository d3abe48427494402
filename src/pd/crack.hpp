#pragma once

#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Rule for bonds that touch a crack without crossing it.
enum class Touching {
  // All bonds that touch the crack are cut.
  cuts_all,
  // Bonds that touch the crack are cut, except those with an end on it: such a bond is cut only if the crack also meets
  // it between its ends, not along it. Points on the crack stay bonded to both faces and bridge it.
  spares_bonds_ending_on_it
};

// Indices of the bonds that a crack cuts: those that meet the polyline `vertices`, its ends included. Points and
// vertices are in lattice coordinates. Distances up to 1e-9 count as touching.
std::vector<int> bonds_cut_by(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                              const std::vector<Point>& vertices, Touching touching = Touching::cuts_all);

// End up to which the bonds of a crack are cut, so that its effective tip lies at the place that was described as its
// end.
struct CutEnd {
  Point end;
  std::vector<int> weakened;  // bonds that meet no crack and have a share of their stiffness only
  double share = 1;
  // Distance ahead of `end` of the place up to which evenly spread bonds would be cut for the same loss of stiffness;
  // none where the end is the tip.
  std::optional<double> even_ahead{};
};

// End of the cut for a crack that comes straight to `tip` in this direction. The effective tip depends on the stiffness
// across the crack's line that is lost. It lies effective_tip_ahead() ahead of the place up to which evenly spread
// bonds would lose as much stiffness as the cut ones do. So bonds are counted by their stiffness across the line, and
// the last ones, those at one place, keep a share that makes the loss right. The end lies at most 1.5 spacings ahead of
// the tip or `backward` spacings behind it; it is the tip itself if there are too few bonds. (docs/verification.md)
CutEnd cut_end_for_tip(const std::vector<Point>& points, const std::vector<Bond>& bonds, const Point& tip,
                       const Point& direction, int horizon_ratio, double backward);

// Distance of the effective tip ahead of the end of the cut, in spacings, measured for horizons of 3 to 6 spacings. It
// scatters by 0.02 to 0.03 over directions and places.
inline double effective_tip_ahead(int horizon_ratio) { return 0.05 * (horizon_ratio + 1); }

// Indices of the material points on the polyline `vertices`, which would be bonded to neither face of the crack.
std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices);

}  // namespace bempd::pd

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
  // Bonds that touch the crack are cut, except bonds with an end on the crack. A bond with an end on the crack is cut
  // only if the crack also crosses the bond between its two ends. Material points on the crack stay bonded to both
  // faces of the crack and bridge it.
  spares_bonds_ending_on_it
};

// Indices of the bonds that a crack cuts: those that meet the polyline `vertices`, its ends included. Points and
// vertices are in lattice coordinates. Distances up to 1e-9 count as touching.
std::vector<int> bonds_cut_by(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                              const std::vector<Point>& vertices, Touching touching = Touching::cuts_all);

// End of a cut: the point up to which a crack cuts bonds, placed so that the effective tip of the crack lies at the
// crack's described end.
struct CutEnd {
  Point end;
  std::vector<int> weakened;  // bonds just ahead of the cut's end that keep only a share of their stiffness
  double share = 1;           // share of their stiffness that the weakened bonds keep
  // Distance ahead of `end` [spacings] of the place up to which evenly spread bonds would have to be cut for the same
  // loss of stiffness as the real cut; empty if `end` is the described tip itself.
  std::optional<double> even_ahead{};
};

// Finds the end of the cut for a crack that comes straight to `tip` in this direction (docs/verification.md). The
// effective tip depends on how much stiffness across the crack's line is lost: it lies effective_tip_ahead() ahead of
// the place up to which evenly spread bonds would lose as much stiffness as the cut bonds do. Bonds are therefore
// counted by their stiffness across the line. The last bonds, which cross the line at one place, keep the share of
// their stiffness that makes the loss right. The cut ends at `tip` itself if there are too few bonds, or if its end
// would lie more than 1.5 spacings ahead of the tip, or more than `backward` (at most 1.5) spacings behind the tip.
CutEnd cut_end_for_tip(const std::vector<Point>& points, const std::vector<Bond>& bonds, const Point& tip,
                       const Point& direction, int horizon_ratio, double backward);

// Distance of the effective tip ahead of the end of a cut through evenly spread bonds [spacings], measured for horizons
// of 3 to 6 spacings. The measured distances scatter by 0.02 to 0.03 over directions and places.
inline double effective_tip_ahead(int horizon_ratio) { return 0.05 * (horizon_ratio + 1); }

// Indices of the material points on the polyline `vertices`, which would be bonded to neither face of the crack.
std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices);

}  // namespace bempd::pd

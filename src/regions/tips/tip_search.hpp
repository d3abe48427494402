#pragma once

#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Tip of a crack in a lattice.
struct LatticeTip {
  int crack, end;  // id; 1: at the crack's last point, 0: at its first
  int region;      // id of the lattice that the crack ends in
  TipAxes axes;
  double horizon;
  double clear;  // radius that contains only this tip and the straight crack behind it
  bool grown;
  bool branched;  // other ways lead on from the crack, too
};

// Tips of cracks in lattices, one for each end that lies inside the body.
//
// A crack passes from cell to cell of the lattice through the bonds of nearest neighbours that it breaks. An end has
// grown if such cells join on to it, side by side or at corners. The tip is then the middle of the cell that is
// farthest along them, and its direction that of the line fitted to the last two horizons of the path. Before that it
// is the end as described.
std::vector<LatticeTip> find_lattice_tips(const BondedBody& body);

// End of a crack in a lattice whose path is known, and which is a tip.
struct KnownTip {
  int crack, end;  // as above
  Point direction;
  std::vector<Point> path;  // ending at the tip
  bool grown;
};
std::vector<LatticeTip> lattice_tips_at(const BondedBody& body, const std::vector<KnownTip>& known);

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Tip of a crack in a lattice, as found for the calculation of its results.
struct LatticeTip {
  int crack, end;  // id; 1: at the crack's last point, 0: at its first
  int region;      // id of the lattice that the crack ends in
  TipAxes axes;
  double horizon;
  double clear;  // radius that contains only this tip and the straight crack behind it
  bool grown;
  bool branched;  // other ways lead on from the crack, too
};

// Finds the tips of cracks in lattices out of broken bonds, one for each end of a described crack that lies inside the
// body.
//
// A crack passes from cell to cell of the lattice through the broken bonds between nearest neighbours. An end has grown
// if such cells join it, side by side or at corners. The tip is then the middle of the cell that is most steps away,
// with the direction of a line fitted to the last two horizons of the path. An end that has not grown is the tip.
std::vector<LatticeTip> find_lattice_tips(const BondedBody& body);

// Tip of a crack in a lattice whose path is known, because the run has grown the crack as a line.
struct KnownTip {
  int crack, end;  // as above
  Point direction;
  std::vector<Point> path;  // ending at the tip
  bool grown;
};
std::vector<LatticeTip> lattice_tips_at(const BondedBody& body, const std::vector<KnownTip>& known);

}  // namespace bempd::regions

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
  double clear;  // radius of a circle with only this tip and the crack behind it [m]
  bool grown;
  bool branched;  // whether broken cells lead on in other directions, too
};

// Finds the tips of cracks in lattices from the broken bonds, one tip for each end of a described crack that lies
// inside the body.
//
// A crack passes from cell to cell of the lattice across the broken bonds between nearest neighbours. An end of a crack
// has grown if such broken cells join this end, side by side or at corners. The tip is then the middle of the broken
// cell that is the most steps away from the end of the crack. Its direction is that of a straight line fitted to the
// last two horizons of the path. If an end has not grown, that end is the tip.
std::vector<LatticeTip> find_lattice_tips(const BondedBody& body);

// Tip of a crack in a lattice whose path is known, because the run has grown the crack as a line.
struct KnownTip {
  int crack, end;  // id of the crack; 1: at its last point, 0: at its first
  Point direction;
  std::vector<Point> path;  // ending at the tip
  bool grown;
};
std::vector<LatticeTip> lattice_tips_at(const BondedBody& body, const std::vector<KnownTip>& known);

}  // namespace bempd::regions

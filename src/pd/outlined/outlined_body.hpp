#pragma once

#include <optional>

#include "pd/network.hpp"
#include "pd/outlined/filling_cells.hpp"

namespace bempd::pd {

// Body with any outline as material points and bonds, in units of the spacing. Nodes of the outline come first.
struct OutlinedBody {
  Chords chords;
  std::vector<Point> points;
  FillingCells cells;
  std::vector<double> areas;    // area of each point
  std::vector<double> factors;  // factors of the surface vectors of the outline's nodes, close to 1
  Network network;
  LatticePlace place;
  bool is_balanced_by_piece = false;  // whether surface vectors are balanced piece by piece (balancing_factors())

  // Whether all stiffnesses are positive and every linear displacement field is reproduced.
  bool is_exact() const { return network.max_residual < 1e-11 && network.min_weight_ratio > 0; }
};

// Builds the bonds between all points that are closer than the horizon and see each other. Far from the outline bonds
// have the lattice's own stiffness. Near the outline stiffnesses change as little as possible from what the kernel and
// the area of each point suggest, so that forces balance the tractions of constant stress on the chords of the outline.
// If that fails, other gaps between the outline and the points inside are tried, then other positions of these points.
// Last, chords of different lengths are balanced piece by piece. The best attempt is returned. 3 <= horizon_ratio <= 8.
OutlinedBody build_outlined_body(const Chords& chords, const LatticePlace& place, int horizon_ratio,
                                 const PlaneElasticity& elasticity, int threads = 0,
                                 const BondKernel& kernel = quartic_kernel());

// Corner of an outline whose surface vector (half the sum of the normals of its two chords, times their lengths) cannot
// be balanced by bonds of positive stiffness. Bonds of the stiffness k, length L and unit vector e from the corner
// balance the surface vector by the sum of k L e. At a corner of at most 180 degrees this sum points at least 30
// degrees away from both edges, for this reason: let a bond have the angle theta from an edge. Balanced bonds have a
// zero sum of k L sin(3 theta + 60), so the sum of k L sin(theta - 30) equals the sum of k L f with
//   f = sin(theta - 30) + sin(3 theta + 60) / sqrt(3) >= 0.
struct ImpossibleCorner {
  int node;
  double angle;           // [rad]
  double before, behind;  // lengths of the chords before and behind the node
};
std::optional<ImpossibleCorner> find_impossible_corner(const Chords& chords);

}  // namespace bempd::pd

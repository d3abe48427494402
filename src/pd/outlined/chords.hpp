#pragma once

#include <vector>

#include "geometry/arc.hpp"

namespace bempd::pd {

// Chord: the straight line between neighbouring material points of an outline, with the body on its left.
struct Chord {
  int first, second;
  int piece;        // number of the piece of the outline, counted through all loops
  double from, to;  // fractions of the piece
};

// Outline of a body as chords, in units of the spacing. Chord k starts at node k.
struct Chords {
  std::vector<Point> nodes;  // exactly on the outline
  std::vector<char> kept{};  // flags of nodes whose surface vectors must not get factors; empty: none
  std::vector<Chord> chords;
  std::vector<int> loop_start;   // first node of each loop, and the end of the last loop
  std::vector<int> piece_start;  // first chord of each piece, and the end of the last piece

  int count() const { return static_cast<int>(nodes.size()); }
  int loop_count() const { return static_cast<int>(loop_start.size()) - 1; }
  int chord_before(int node) const;
  Point along(int chord) const { return nodes[chords[chord].second] - nodes[chords[chord].first]; }
  double length(int chord) const { return along(chord).norm(); }
  // Outward normal of a chord, times the chord's length.
  Point normal(int chord) const { return {along(chord).y(), -along(chord).x()}; }
  // Surface vector of a node: half the sum of normal() of the two chords that meet there.
  Point surface_vector(int node) const { return 0.5 * (normal(node) + normal(chord_before(node))); }
  // Interior angle of the body at a node [rad].
  double angle(int node) const;
};

// Makes the chords of loops whose pieces have the body on their left. A piece gets about as many chords as its length
// in spacings. The chords of a piece are equally long, except on pieces marked in `may_vary` (by number of the piece):
// there the lengths vary if this balances the loop without factors (surface_balance.hpp).
Chords make_chords(const std::vector<std::vector<Arc>>& loops, const std::vector<char>& may_vary = {});

}  // namespace bempd::pd

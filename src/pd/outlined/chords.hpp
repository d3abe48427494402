#pragma once

#include <vector>

#include "geometry/arc.hpp"

namespace bempd::pd {

// Chord: the straight line between neighbouring material points of an outline, with the body on its left.
struct Chord {
  int first, second;
  int piece;        // of the outline, counted through all loops
  double from, to;  // fractions of the piece
};

// Outline of a body as chords, of equal length on every piece, in units of the spacing. Chord k starts at node k.
struct Chords {
  std::vector<Point> nodes;  // exactly on the outline
  std::vector<char> kept{};  // nodes whose surface vectors others rely on; empty for none
  std::vector<Chord> chords;
  std::vector<int> loop_start;   // of the nodes, and the end of the last loop
  std::vector<int> piece_start;  // of the chords, and the end of the last piece

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

// Makes the chords of loops whose pieces have the body on their left; a piece gets as many chords as it is spacings
// long. Chords of a piece are equal. Only on pieces with `may_vary` (by number) may they differ in length, where this
// balances a loop (surface_balance.hpp) without factors.
Chords make_chords(const std::vector<std::vector<Arc>>& loops, const std::vector<char>& may_vary = {});

}  // namespace bempd::pd

#pragma once

#include <algorithm>
#include <vector>

#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/material_points.hpp"
#include "regions/outlined/joined_outline.hpp"

namespace bempd::regions {

// Outline of a peridynamic region, or of several regions that are one body. The outline consists of pieces of edges,
// and each piece is divided into chords. The ends of chords are material points, here called nodes of the outline.
class DividedOutline {
 public:
  // Piece of an edge. Its chords are equally long, unless the outline can only be balanced with different lengths.
  struct Piece {
    int region, edge;  // id; number
    double from, to;   // fractions of the edge's length
    Arc arc;           // in grid coordinates
  };

  DividedOutline(std::vector<int> regions, const MaterialPoints& grid) : regions_(std::move(regions)), grid_(grid) {}

  // Divides the outline into chords. Returns false if the regions have no common outline (loops_around()).
  bool divide(const Preparation& preparation);
  bool is_divided() const { return !pieces_.empty(); }
  bool is_around(int region) const { return std::binary_search(regions_.begin(), regions_.end(), region); }
  bool has_impossible_corner() const { return pd::find_impossible_corner(chords_).has_value(); }
  // Throws Error (argument) if the outline has a corner at which no positive bond stiffnesses can balance the tractions
  // of a constant stress.
  void require_possible_corners() const;
  // Flags of the nodes that other regions have too: all nodes on interfaces, but only the end points of an interface on
  // which the host has chosen the elements of the neighbour (has_own_mesh()). Also marks the surface vectors of all
  // nodes on interfaces as fixed (Chords::kept), so that balancing the outline does not change them.
  std::vector<char> shared_nodes(const Preparation& preparation);

  const pd::Chords& chords() const { return chords_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  const Piece& piece_of(const pd::Chord& chord) const { return pieces_[static_cast<std::size_t>(chord.piece)]; }
  // Chords on an edge of a region, in order along the edge.
  std::vector<pd::Chord> chords_on(int region, int edge) const;
  // Fraction of the length of the edge at the place `part` of a chord: 0 is the first end of the chord, 1 the second.
  double fraction(const pd::Chord& chord, double part) const;
  // Places of the nodes on an interface, in order along the region's edge [m].
  std::vector<Point> places_on(const Edge& edge, const Contact& own) const;

 private:
  std::vector<double> stations_on(const Preparation& preparation, const BorderPart& part) const;
  std::vector<char> pieces_that_may_vary(const Preparation& preparation) const;

  std::vector<int> regions_;  // ids
  const MaterialPoints& grid_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Arc>> loops_;
  pd::Chords chords_;
};

}  // namespace bempd::regions

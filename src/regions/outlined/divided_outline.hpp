#pragma once

#include <algorithm>
#include <vector>

#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/material_points.hpp"
#include "regions/outlined/joined_outline.hpp"
#include "regions/region_borders.hpp"
#include "regions/region_loads.hpp"

namespace bempd::regions {

// Outline of a peridynamic region, or of several that are one body, as chords: pieces of edges, each divided into equal
// chords, whose ends are material points.
class DividedOutline {
 public:
  // Piece of an edge that is divided into equal chords.
  struct Piece {
    int region, edge;  // id; number
    double from, to;
    Arc arc;  // in grid coordinates
  };

  DividedOutline(std::vector<int> regions, const MaterialPoints& grid) : regions_(std::move(regions)), grid_(grid) {}

  // Divides the outline. Returns false if there is none around all regions.
  bool divide(const Preparation& preparation);
  bool is_divided() const { return !pieces_.empty(); }
  bool is_around(int region) const { return std::binary_search(regions_.begin(), regions_.end(), region); }
  bool has_impossible_corner() const { return pd::find_impossible_corner(chords_).has_value(); }
  // Throws Error (argument) for a corner at which no positive bond stiffnesses balance the outline.
  void require_possible_corners() const;
  // Flags of nodes of chords that are nodes of other regions too: all on matching interfaces, only the end points of
  // others. The surface vectors of these nodes are marked to be kept when the outline is balanced.
  std::vector<char> shared_nodes(const Preparation& preparation);

  const pd::Chords& chords() const { return chords_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  const Piece& piece_of(const pd::Chord& chord) const { return pieces_[static_cast<std::size_t>(chord.piece)]; }
  // Chords on an edge of a region, in order.
  std::vector<pd::Chord> chords_on(int region, int edge) const;
  // Fraction of its edge at a part of a chord.
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

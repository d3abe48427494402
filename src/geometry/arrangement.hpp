#pragma once

#include <optional>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

// Piece of an edge that two regions share, with a body on either side. Fractions run along each edge from its start.
// The edges run against each other, so from < to and other_from > other_to; other_from is the same place as from.
struct Contact {
  int region, edge;
  double from, to;
  int other_region, other_edge;
  double other_from, other_to;
};

// Two regions (region_a < region_b) whose interiors have points in common; `where` is on the boundary of one of them
// and in the closure of the other.
struct Overlap {
  int region_a, region_b;
  Point where;
};

// Point where regions touch without all of them being connected there through shared pieces of boundary: a material
// hinge. Each group is connected in itself; the groups share only the point.
struct PointTouch {
  Point where;
  std::vector<std::vector<int>> groups;
};

struct Arrangement {
  // Shared pieces, each once for either side; sorted by region, edge and from.
  std::vector<Contact> contacts;
  // [region][edge]: sorted fractions in (0, 1) where a vertex of another region touches the edge or a contact starts or
  // ends. The fractions of the contacts are these numbers exactly, or 0 or 1.
  std::vector<std::vector<std::vector<double>>> breakpoints;
  std::optional<Overlap> overlap;
  std::vector<PointTouch> hinges;
};

// Finds how sound outlines (check_outline) lie against each other. Places closer than the geometric tolerance of all of
// them together count as one.
Arrangement arrange(const std::vector<Outline>& regions);

}  // namespace bempd

#pragma once

#include <optional>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

// Contact: a piece of an edge that two regions share, one on either side. Fractions run along each edge from its start.
// The two edges run in opposite directions, so from < to and other_from > other_to; other_from is the same place as
// from.
struct Contact {
  int region, edge;
  double from, to;
  int other_region, other_edge;
  double other_from, other_to;
};

// Overlap of two regions (region_a < region_b), whose interiors have points in common. `where` lies on the boundary of
// one of them, and inside the other or on its boundary.
struct Overlap {
  int region_a, region_b;
  Point where;
};

// Material hinge: a point where regions touch that are not all connected through shared pieces of boundary there. Each
// group of regions is connected in itself; different groups share only the point.
struct PointTouch {
  Point where;
  std::vector<std::vector<int>> groups;
};

struct Arrangement {
  // Shared pieces of boundary, each entered once for either side, sorted by region, edge and from.
  std::vector<Contact> contacts;
  // Break points [region][edge]: ascending fractions in (0, 1) at which a vertex of another region touches the edge, or
  // a contact starts or ends. The fractions of the contacts are exactly these numbers, or 0 or 1.
  std::vector<std::vector<std::vector<double>>> breakpoints;
  std::optional<Overlap> overlap;
  std::vector<PointTouch> hinges;
};

// Finds how the outlines of regions lie against each other; each must be sound (check_outline). Places closer than the
// geometric tolerance of all regions together count as one.
Arrangement arrange(const std::vector<Outline>& regions);

}  // namespace bempd

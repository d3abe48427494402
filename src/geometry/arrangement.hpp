#pragma once

#include <optional>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

// Contact: a piece of boundary that two regions share, one on either side. Fractions run along each region's edge from
// its start. The two edges run in opposite directions, so that from < to and other_from > other_to; `from` and
// `other_from` are the same place.
struct Contact {
  int region, edge;
  double from, to;
  int other_region, other_edge;
  double other_from, other_to;
};

// Overlap of two regions (region_a < region_b), whose interiors have points in common. `where` lies on the boundary of
// one region, and inside the other one or on its boundary.
struct Overlap {
  int region_a, region_b;
  Point where;
};

// Material hinge: a point where regions touch, some of them only in this point. Each group of regions is connected
// through shared pieces of boundary at the point; different groups have only the point in common.
struct PointTouch {
  Point where;
  std::vector<std::vector<int>> groups;
};

struct Arrangement {
  // Shared pieces of boundary, each listed twice (for either region), sorted by region, edge and from.
  std::vector<Contact> contacts;
  // Break points as [region][edge]: ascending fractions in (0, 1) at which a vertex of another region touches the edge,
  // or a contact starts or ends. The fractions of contacts are exactly these numbers, or 0 or 1.
  std::vector<std::vector<std::vector<double>>> breakpoints;
  std::optional<Overlap> overlap;
  std::vector<PointTouch> hinges;
};

// Finds contacts, overlaps and hinges of regions, whose outlines must be sound (check_outline). Places closer than the
// geometric tolerance of all regions together count as one.
Arrangement arrange(const std::vector<Outline>& regions);

}  // namespace bempd

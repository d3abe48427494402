#pragma once

#include <vector>

#include "regions/preparation.hpp"

namespace bempd::regions {

// Part of an edge of a region, between two fractions of its length.
struct BorderPart {
  int region, edge;  // id; number
  double from, to;
};

// Loops around the body that the regions (ids, ascending) form together, with the body on their left. Loops consist of
// those parts of edges that are not common to two of the regions. The result is empty unless the parts form loops in
// exactly one way.
std::vector<std::vector<BorderPart>> loops_around(const std::vector<int>& regions, const Preparation& preparation);

}  // namespace bempd::regions

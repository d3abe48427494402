#pragma once

#include <vector>

#include "regions/preparation.hpp"

namespace bempd::regions {

// Part of an edge of a region, between two fractions of its length.
struct BorderPart {
  int region, edge;  // id; number
  double from, to;
};

// Loops around the body that some regions (ids, ascending) form together, with the body on the left: the parts of their
// edges that are no common edges of two of them. Empty if these do not close in one way only.
std::vector<std::vector<BorderPart>> loops_around(const std::vector<int>& regions, const Preparation& preparation);

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

// Gap: a place where two regions (region_a < region_b) come close without touching, with no other region between them.
struct Gap {
  int region_a, region_b;
  double width;
  Point where;  // half way between the two regions
};

// Narrowest gap between each pair of regions, if it is narrower than `reach` of both (one entry per region) and wider
// than the geometric tolerance of all regions together, within which edges coincide. Gaps are sorted by the numbers of
// their regions.
std::vector<Gap> close_gaps(const std::vector<Outline>& regions, const std::vector<double>& reach);

}  // namespace bempd

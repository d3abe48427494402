#pragma once

#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

// Place where two regions (region_a < region_b) come close without touching, with nothing between them.
struct Gap {
  int region_a, region_b;
  double width;
  Point where;  // half way between the two
};

// Narrowest gap of every two regions, if it is below the reach of both and above the geometric tolerance of all of them
// together, within which edges coincide. Ascending by the numbers of the regions.
std::vector<Gap> close_gaps(const std::vector<Outline>& regions, const std::vector<double>& reach);

}  // namespace bempd

#pragma once

#include "scene/place.hpp"

namespace bempd::regions {

// Place that is not on an edge. No element has to end at such a place, and the place covers no part of the boundary.
class OffEdges : public scene::Place {
 public:
  std::vector<double> breaks_on(const scene::Scene&, int, int, double) const final { return {}; }
  bool covers(int, int, double) const final { return false; }
};

}  // namespace bempd::regions

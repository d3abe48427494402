#pragma once

#include "scene/place.hpp"

namespace bempd::regions {

// Place that lies on no edge: elements need not end for it, and it covers no piece of boundary.
class OffEdges : public scene::Place {
 public:
  std::vector<double> breaks_on(const scene::Scene&, int, int, double) const final { return {}; }
  bool covers(int, int, double) const final { return false; }
};

}  // namespace bempd::regions

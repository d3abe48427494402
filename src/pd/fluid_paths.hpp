#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// Facet that a crack opens between two neighbouring points where the bond between them, one spacing long, is broken:
// the part of the line between these points that lies beside them. Facets that continue each other end at one place.
struct CrackFacet {
  int term;  // the bond, of the scene
  Point from, to;
  std::array<int, 2> places;  // numbers of its ends
};

// Paths of a fluid in cracks among bonds, and its forces.
struct FluidPaths {
  std::vector<CrackFacet> facets;  // of all bonds one spacing long, whole or not
  // Force along each term by the pressure, under a pressure on all sides of the body [N/Pa]. As bond forces do for any
  // constant stress, the forces of the terms across any line have the resultant of the pressure there. So a pressure in
  // a crack is applied as these forces with the opposite sign at the broken terms.
  std::vector<double> push;
};

}  // namespace bempd::pd

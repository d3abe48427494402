#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// What a crack opens between two neighbouring points where their bond, one spacing long, is gone: the part of the line
// between them that lies beside these two points. Facets that join on to each other end at one place.
struct CrackFacet {
  int term;  // the bond, of the scene
  Point from, to;
  std::array<int, 2> places;  // numbers of its ends
};

// Where a fluid can go in cracks among bonds, and what it does.
struct FluidWays {
  std::vector<CrackFacet> facets;  // of all bonds one spacing long, whole or not
  // Per term: force along it, by the pressure, under a pressure on all sides of the body [N/Pa]. The forces of terms
  // across any line have the resultant of the pressure there, as those of bonds have of any constant stress; so where
  // they are gone the same forces, the other way, are what a pressure in the line does.
  std::vector<double> push;
};

}  // namespace bempd::pd

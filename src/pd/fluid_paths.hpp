#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"
#include "pd/weakened_term.hpp"

namespace bempd::pd {

// Facet: piece of crack surface that opens between two neighbouring material points when the bond between these points,
// one spacing long, breaks. The facet crosses the bond at its middle. Facets that continue each other share the number
// of an end.
struct CrackFacet {
  int term;  // number of the bond in the scene
  Point from, to;
  std::array<int, 2> places;  // numbers of its ends
};

// Paths of a fluid in cracks among bonds, and the forces that the pressure of the fluid exerts.
struct FluidPaths {
  std::vector<CrackFacet> facets;  // facets of all bonds one spacing long, broken or not
  // Force along each energy term (bond or cell square) due to a unit pressure on all sides of the body [N/Pa]. The
  // forces of all energy terms that cross a line have the same resultant as the pressure on this line. The pressure in
  // a crack is therefore applied as these forces, with the opposite sign, at the broken energy terms. A weakened term
  // gets the force that it would have with its whole stiffness.
  std::vector<double> push;
  // Weakened terms ahead of the ends of cracks. The fluid in a pressurised crack also acts at these terms, with `push`
  // times the share of stiffness that the term has lost.
  std::vector<WeakenedTerm> weakened;
};

}  // namespace bempd::pd

#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"
#include "pd/weakened_term.hpp"

namespace bempd::pd {

// Facet that a crack opens between two neighbouring points when the bond between them, one spacing long, breaks: the
// part of the crack that belongs to these points, across the bond. Facets that continue each other share the number of
// an end.
struct CrackFacet {
  int term;  // the bond, of the scene
  Point from, to;
  std::array<int, 2> places;  // numbers of its ends
};

// Paths of a fluid in cracks among bonds, and the forces of its pressure.
struct FluidPaths {
  std::vector<CrackFacet> facets;  // of all bonds one spacing long, whole or not
  // Force along each term due to a unit pressure on all sides of the body [N/Pa]. As in any constant stress, the forces
  // of the terms across a line have the resultant of the pressure on it. So the pressure in a crack is applied as these
  // forces, with the opposite sign, at the broken terms. Terms count with their whole stiffness, also weakened ones.
  std::vector<double> push;
  // Weakened terms ahead of crack ends. In a pressurised crack the fluid acts there too, by `push` times the share of
  // stiffness that they have lost.
  std::vector<WeakenedTerm> weakened;
};

}  // namespace bempd::pd

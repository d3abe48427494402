#pragma once

#include <complex>
#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

enum class SingularKind { corner = 1, interface, crack, point };

// Place where the stress of the elastic body is unbounded. Near the place, displacements vary as r^exponent with the
// distance r. At a single point with a force or support the exponent is 0 (logarithm).
struct SingularPlace {
  SingularKind kind;
  int region;  // id of a region at the place
  Point place;
  std::complex<double> exponent;
};

// Singular places of the scene, except cracks in peridynamic regions, where bonds break at a finite stretch.
std::vector<SingularPlace> singular_places(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

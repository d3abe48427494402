#pragma once

#include <complex>
#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

enum class SingularKind { corner = 1, interface, crack, point };

// Place where the stress of the elastic body is unbounded: near it displacements vary with the distance r as
// r^exponent. At a loaded or held single point the exponent is 0 (logarithm).
struct SingularPlace {
  SingularKind kind;
  int region;  // one that is there
  Point place;
  std::complex<double> exponent;
};

// Singular places of the scene, except cracks in peridynamic regions, where bonds break at a finite stretch.
std::vector<SingularPlace> singular_places(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

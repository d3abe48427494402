#pragma once

#include <complex>
#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

enum class SingularKind { corner = 1, interface, crack, point };

// A place where the stress of the elastic body is unbounded: beside it displacements go as r to the exponent.
struct SingularPlace {
  SingularKind kind;
  int region;  // one that is there
  Point place;
  std::complex<double> exponent;
};

// All of them but those that are open questions of breaking: cracks in peridynamic regions.
std::vector<SingularPlace> singular_places(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

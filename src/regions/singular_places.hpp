#pragma once

#include <complex>
#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

enum class SingularKind { corner = 1, interface, crack, point };

// Place where the stress of the elastic body is unbounded: beside it displacements go as r to the exponent.
struct SingularPlace {
  SingularKind kind;
  int region;  // one that is there
  Point place;
  std::complex<double> exponent;
};

// All singular places, except cracks in peridynamic regions, where breaking decides.
std::vector<SingularPlace> singular_places(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

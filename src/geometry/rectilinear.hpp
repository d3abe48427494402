#pragma once

#include <array>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd {

using LatticePoint = Eigen::Vector2i;

// Outline whose edges follow the lines of a square lattice. Lattice point (i, j) is at origin + spacing * (i, j). The
// origin is the lower left corner of the bounding box, so that all i and j are >= 0.
struct LatticeOutline {
  Point origin = Point::Zero();
  double spacing = 0;
  std::vector<std::vector<LatticePoint>> loops;    // loops without the vertices between collinear edges
  std::vector<std::array<LatticePoint, 2>> edges;  // start and end of each edge of the given outline
};

enum class LatticeMisfit {
  none,
  bad_spacing,       // not a positive finite number, or so small that cells cannot be told apart or counted
  oblique_edge,      // edge `edge` is parallel to neither axis
  indivisible_edge,  // edge `edge` of length `length` is not a whole number of spacings
  shifted_hole       // hole `loop`, starting with edge `edge`, is `length` away from the first vertex along an axis,
                     // which is not a whole number of spacings
};

struct LatticeFit {
  LatticeMisfit misfit = LatticeMisfit::none;
  int edge = -1;
  int loop = -1;
  double length = 0;
  // Suggested spacings if a length is not a whole number of spacings: close to the requested one, smallest first, and
  // fitting the whole outline. Short decimal numbers are preferred. Empty if the lengths have no useful common measure.
  std::vector<double> suggestions;
  LatticeOutline outline;  // empty if there is a misfit

  bool fits() const { return misfit == LatticeMisfit::none; }
};

// Fits an outline, which must be sound (check_outline), to a lattice with this spacing. A length fits if it is a whole
// number of spacings up to the outline's geometric tolerance, 1e-9 of its size. Coordinates typed with ten digits fit,
// and wrong spacings are off by far more.
LatticeFit fit_lattice(const Outline& outline, double spacing);

// Spacings within a factor three of `wanted` that divide all `lengths` up to `tolerance`: `wanted` itself if possible,
// else at most one smaller and one larger spacing; empty if there is none.
std::vector<double> spacings_near(double wanted, const std::vector<double>& lengths, double tolerance);

}  // namespace bempd

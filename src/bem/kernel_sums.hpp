#pragma once

#include <array>

#include "bem/pair_integrals.hpp"

namespace bempd::bem {

// Adds the integrals over a pair of intervals that do not touch to `moments`, by the product of their quadrature rules.
void add_kernel_sums(const ElementPoints& outer, const ElementPoints& inner, PairPart part, PairMoments& moments);

// Quadrature points of a pair of elements that touch, in coordinates (radius, angle) in which the distance is r =
// radius * chord. For each angle there are points at all radii, side by side for the vector unit.
struct SingularPoints {
  static constexpr int most_radii = 20, most_angles = 20;
  using Values = std::array<double, most_radii>;
  struct Pair {
    Values chord_x, chord_y;
    Values weight, log_weight;  // log_weight integrates ln(radius)
  };
  struct Side {
    Values normal_x, normal_y;         // outward normal * Jacobian
    std::array<Values, 3> mass;        // N_k * Jacobian
    std::array<Values, 3> derivative;  // dN_k/dxi
    std::array<Values, 3> difference;  // the element's part of (N_b(y) - N_b(x)) / radius
  };

  const Side& inner_at(int angle) const { return inner[inner_ignores_angle ? 0 : angle]; }

  int radii = 0, angles = 0;
  bool outer_ignores_angle = false, inner_ignores_angle = false;  // whether all angles at a radius have the same point
  bool has_outer_part = true;  // whether the outer element contributes to the difference
  std::array<Pair, most_angles> pairs;
  std::array<Side, most_angles> outer, inner;
};

void add_singular_sums(const SingularPoints& points, PairPart part, PairMoments& moments);

}  // namespace bempd::bem

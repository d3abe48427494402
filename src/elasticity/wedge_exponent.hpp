#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "elasticity/plane_elasticity.hpp"

namespace bempd {

// One material between two rays from a point.
struct WedgeSector {
  double opening;  // [rad], > 0
  PlaneElasticity elasticity;
};

// Sectors side by side, counter-clockwise from an angle, bonded to each other where they meet; if `closed` the last one
// to the first. Components of the displacement that are held on the rays, from the first to the last one: 1 x, 2 y,
// 3 both; none is held on a free face or inside. One ray more than sectors unless closed.
struct Wedge {
  double angle = 0;
  std::vector<WedgeSector> sectors;
  std::vector<int> held;
  bool closed = false;
};

// The largest exponent that counts: stress grows as r^-0.01 at least.
constexpr double largest_singular_exponent = 0.99;

// Exponent of the displacement next to the point where stress grows fastest, r to the power of it: the solution of the
// equations of the wedge with the least real part between 0 and largest_singular_exponent, of a conjugate pair that
// with the positive imaginary part. Nothing if stress is bounded.
std::optional<std::complex<double>> singular_exponent(const Wedge& wedge);

}  // namespace bempd

#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "elasticity/plane_elasticity.hpp"

namespace bempd {

// Material between two rays from a point.
struct WedgeSector {
  double opening;  // [rad], > 0
  PlaneElasticity elasticity;
};

// Sectors around a point, counter-clockwise from an angle, each bonded to the next; if `closed`, the last one to the
// first. `held` has the held displacement components on the rays, from the first to the last: 1 x, 2 y, 3 both, 0 on a
// free face or inside. There is one ray more than sectors unless the wedge is closed.
struct Wedge {
  double angle = 0;
  std::vector<WedgeSector> sectors;
  std::vector<int> held;
  bool closed = false;
};

// Largest exponent that counts as singular: stress grows as r^-0.01 at least.
constexpr double largest_singular_exponent = 0.99;

// Exponent of the displacement next to the point where stress grows fastest: displacement is r to this power. It is the
// solution of the wedge's equations with the least real part between 0 and largest_singular_exponent; of a conjugate
// pair, the one with the positive imaginary part. Empty if stress is bounded.
std::optional<std::complex<double>> singular_exponent(const Wedge& wedge);

}  // namespace bempd

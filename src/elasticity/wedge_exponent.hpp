#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "elasticity/plane_elasticity.hpp"

namespace bempd {

// Sector of a wedge: the material between two rays from the wedge's point.
struct WedgeSector {
  double opening;  // [rad], > 0
  PlaneElasticity elasticity;
};

// Wedge: sectors around a point, counter-clockwise from the ray at `angle`. Each sector is bonded to the next one and,
// if `closed`, the last sector to the first. `held` tells for each ray which displacement components are held: 1 x, 2
// y, 3 both, 0 none (a free face or an interface). Unless the wedge is closed, there is one more ray than sectors.
struct Wedge {
  double angle = 0;
  std::vector<WedgeSector> sectors;
  std::vector<int> held;
  bool closed = false;
};

// Largest exponent of the displacement that counts as singular; the stress then grows at least as r^-0.01.
constexpr double largest_singular_exponent = 0.99;

// Exponent of the strongest stress singularity at the wedge's point: the displacement is ~ r to this power. It is the
// solution of the wedge's equations with the least real part, between 0 and largest_singular_exponent; of a conjugate
// pair, the solution with the positive imaginary part. Empty if the stress is bounded.
std::optional<std::complex<double>> singular_exponent(const Wedge& wedge);

}  // namespace bempd

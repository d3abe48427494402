#pragma once

#include <numbers>

#include "pd/bond_kernel.hpp"

namespace bempd::pd::test {

// Another kernel than the engine's, c0 (1 - r/delta) with c0 = 32 C1111 / (pi delta^3): what is said of every kernel is
// tested with two.
inline const BondKernel& conical_kernel() {
  class Conical final : public BondKernel {
   public:
    const char* name() const override { return "conical"; }
    double micromodulus(double length, double horizon) const override {
      return 32 / std::numbers::pi / (horizon * horizon * horizon) * (1 - length / horizon);
    }
    double energy_number() const override { return 32.0 / 20; }
  };
  static const Conical kernel;
  return kernel;
}

}  // namespace bempd::pd::test

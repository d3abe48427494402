#include "pd/bond_kernel.hpp"

#include <numbers>

#include "pd/micromodulus.hpp"

namespace bempd::pd {

namespace {

class Quartic final : public BondKernel {
 public:
  const char* name() const override { return "quartic"; }
  double micromodulus(double length, double horizon) const override { return pd::micromodulus(length, horizon); }
  double energy_number() const override { return 35.0 / 24; }
};

class Conical final : public BondKernel {
 public:
  const char* name() const override { return "conical"; }
  double micromodulus(double length, double horizon) const override {
    return 32 / std::numbers::pi / (horizon * horizon * horizon) * (1 - length / horizon);
  }
  double energy_number() const override { return 32.0 / 20; }
};

}  // namespace

const BondKernel& quartic_kernel() {
  static const Quartic kernel;
  return kernel;
}

const BondKernel& conical_kernel() {
  static const Conical kernel;
  return kernel;
}

}  // namespace bempd::pd

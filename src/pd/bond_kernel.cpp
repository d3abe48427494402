#include "pd/bond_kernel.hpp"

#include "pd/micromodulus.hpp"

namespace bempd::pd {

namespace {

class Quartic final : public BondKernel {
 public:
  const char* name() const override { return "quartic"; }
  double micromodulus(double length, double horizon) const override { return pd::micromodulus(length, horizon); }
  double energy_number() const override { return 35.0 / 24; }
};

}  // namespace

const BondKernel& quartic_kernel() {
  static const Quartic kernel;
  return kernel;
}

}  // namespace bempd::pd

#pragma once

namespace bempd::pd {

// Kernel: how the stiffness of bonds falls with their length, for C1111 = 1 and lengths in units of the lattice
// spacing.
class BondKernel {
 public:
  virtual ~BondKernel() = default;

  // Name of the kernel. Two kernels with the same name count as the same kernel.
  virtual const char* name() const = 0;

  // Micromodulus c(r) of a bond of the length r, with C1111 = 3 pi / 8 * integral of c r^2 over 0 < r < horizon.
  virtual double micromodulus(double length, double horizon) const = 0;

  // Dimensionless fracture energy pi * integral of c r^3 / horizon, with the micromodulus c(r) of a bond of the length
  // r. G0 = s_c^2 * integral of c r^3 is the energy per area that breaks all bonds across a plane at the critical
  // stretch s_c (Silling and Askari, Comput. Struct. 83, 2005, in two dimensions).
  virtual double energy_number() const = 0;
};

// Kernel c0 (1 - r^2/delta^2)^2 for a bond of the length r and the horizon delta, with c0 = 35 C1111 / (pi delta^3):
// see micromodulus.hpp.
const BondKernel& quartic_kernel();

}  // namespace bempd::pd

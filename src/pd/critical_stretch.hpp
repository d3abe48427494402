#pragma once

#include <cmath>
#include <numbers>

#include "elasticity/plane_elasticity.hpp"
#include "pd/bond_kernel.hpp"

namespace bempd::pd {

// Factor a in G0 = a E horizon s_c^2, with Young's modulus E, the critical stretch s_c and the energy G0 per area that
// separates a plane. Up to the Poisson's ratio nu of a bond-based solid, bonds take all of this energy, and the factor
// is energy_number() / pi times C1111 / E of the bonds, where C1111 / E is 9/8 in plane stress and 6/5 in plane strain
// at that ratio. At larger nu bonds take a part of the energy and cell squares (cell_squares.hpp) the rest. The factor
// is then energy_number() / pi times 9/8 E' / E, where E' = E in plane stress and E / (1 - nu^2) in plane strain.
double fracture_energy_factor(const PlaneElasticity& elasticity, const BondKernel& kernel = quartic_kernel());

// Critical stretch, at which a bond breaks, for a fracture energy [J/m^2] and a horizon [m].
double critical_stretch(double fracture_energy, const PlaneElasticity& elasticity, double horizon,
                        const BondKernel& kernel = quartic_kernel());

double fracture_energy(double critical_stretch, const PlaneElasticity& elasticity, double horizon,
                       const BondKernel& kernel = quartic_kernel());

// Ratio of the energy that a growing crack dissipates in a lattice whose bonds break one by one to G0. The energy is
// the mean over directions of what breaking bonds release per length of crack (docs/directions.md; `benchmarks/run.sh
// directions` prints it). The ratio is above 1 where bonds beside the crack break as well.
double running_energy(int horizon_ratio);

// Fracture energy factor in plane stress with the constant as printed by Huang et al. (2015) and in Eq. 15 of Yang and
// Liu (2021), which makes the energy 1.7 % too large and the stretch 0.8 % too small. Only for reproducing published
// numbers.
inline double printed_fracture_energy_factor() {
  using std::numbers::pi;
  return 7 * (120 * pi - 133) / (1024 * pi);
}

inline double printed_critical_stretch(double fracture_energy, double young_modulus, double horizon) {
  return std::sqrt(fracture_energy / (printed_fracture_energy_factor() * young_modulus * horizon));
}

}  // namespace bempd::pd

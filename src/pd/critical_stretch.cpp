#include "pd/critical_stretch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "elasticity/griffith.hpp"
#include "pd/cell_squares.hpp"

namespace bempd::pd {

double fracture_energy_factor(const PlaneElasticity& elasticity, const BondKernel& kernel) {
  const double number = kernel.energy_number();
  if (is_bond_based(elasticity))
    return (elasticity.state == PlaneState::stress ? number * 9 / 8 : number * 6 / 5) / std::numbers::pi;
  const bool is_below = elasticity.c12() < elasticity.shear_modulus();
  const double stiffness = is_below ? bond_c1111(elasticity) : 9.0 / 8 * plane_modulus(elasticity);
  return number * stiffness / elasticity.young_modulus / std::numbers::pi;
}

double critical_stretch(double fracture_energy, const PlaneElasticity& elasticity, double horizon,
                        const BondKernel& kernel) {
  return std::sqrt(fracture_energy / (fracture_energy_factor(elasticity, kernel) * elasticity.young_modulus * horizon));
}

double running_energy(int horizon_ratio) {
  constexpr std::array from_2 = {1.70, 1.30, 1.07};
  const int place = std::max(0, horizon_ratio - 2);
  return place < static_cast<int>(from_2.size()) ? from_2[static_cast<std::size_t>(place)] : 1;
}

double fracture_energy(double critical_stretch, const PlaneElasticity& elasticity, double horizon,
                       const BondKernel& kernel) {
  return fracture_energy_factor(elasticity, kernel) * elasticity.young_modulus * horizon * critical_stretch *
         critical_stretch;
}

}  // namespace bempd::pd

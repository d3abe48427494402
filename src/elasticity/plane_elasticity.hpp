#pragma once

namespace bempd {

enum class PlaneState { stress = 1, strain = 2 };

// Isotropic linear elasticity in the plane. Stress vectors are ordered (xx, yy, xy).
struct PlaneElasticity {
  double young_modulus = 0;  // [Pa]
  double poisson_ratio = 0;  // [-]
  PlaneState state = PlaneState::stress;
  double thickness = 1;  // [m]

  double shear_modulus() const { return young_modulus / (2 * (1 + poisson_ratio)); }

  // Whether the material is in plane strain and incompressible (Poisson's ratio 1/2).
  bool incompressible() const { return state == PlaneState::strain && poisson_ratio > largest_ratio; }

  // Poisson's ratio for plane-strain formulas: nu itself in plane strain, nu / (1 + nu) in plane stress. Incompressible
  // solids get the small compressibility 1 - 2 nu = 2e-8: the error by this value, and the digits lost in the pressure,
  // are then both about 1e-8 of the results.
  double effective_poisson_ratio() const {
    if (state == PlaneState::stress) return poisson_ratio / (1 + poisson_ratio);
    return incompressible() ? largest_ratio : poisson_ratio;
  }

  // Stiffness c11 in sigma_xx = c11 eps_xx + c12 eps_yy. (The shear stress is sigma_xy = 2 G eps_xy.)
  double c11() const {
    const double nu = effective_poisson_ratio();
    return 2 * shear_modulus() * (1 - nu) / (1 - 2 * nu);
  }
  double c12() const {
    const double nu = effective_poisson_ratio();
    return 2 * shear_modulus() * nu / (1 - 2 * nu);
  }

  bool operator==(const PlaneElasticity&) const = default;

  static constexpr double largest_ratio = 0.5 - 1e-8;
};

// Poisson's ratio of a bond-based peridynamic solid, whose stiffness tensor is totally symmetric.
inline double bond_based_poisson_ratio(PlaneState state) { return state == PlaneState::stress ? 1.0 / 3.0 : 0.25; }

}  // namespace bempd

#pragma once

#include "coupling/term_law.hpp"
#include "crack/laws/resistance.hpp"
#include "elasticity/plane_elasticity.hpp"

namespace bempd::scene {

struct Material {
  PlaneElasticity elasticity;
  double critical_stretch = 0;   // 0: not given
  double fracture_energy = 0;    // [J/m^2]; 0: not given
  double thermal_expansion = 0;  // [1/K]
  // Law of this material's bonds: the damage stages that a bond goes through from its critical stretch on.
  coupling::TermLaw bond_law = coupling::TermLaw::brittle();
  crack::Resistance resistance = {};  // rules for the fracture energy that tips meet, beyond `fracture_energy`

  bool operator==(const Material&) const = default;

  // Thermal strain in the plane per temperature, of a body that is free in the plane [1/K].
  double expansion_in_plane() const {
    return thermal_expansion * (elasticity.state == PlaneState::strain ? 1 + elasticity.poisson_ratio : 1);
  }

  // Throws Error (argument) if a value is outside of the range that materials can have.
  void check() const;

  // Critical stretch for a horizon [m]; infinite if the material does not break. `as_printed` chooses the constant of
  // Yang and Liu 2021, Eq. 15.
  double critical_stretch_for(double horizon, bool as_printed) const;
};

}  // namespace bempd::scene

#pragma once

#include "coupling/term_law.hpp"
#include "elasticity/plane_elasticity.hpp"

namespace bempd::scene {

struct Material {
  PlaneElasticity elasticity;
  double critical_stretch = 0;  // 0: not given
  double fracture_energy = 0;   // [J/m^2]; 0: not given
  // What bonds go through from the critical stretch on.
  coupling::TermLaw bond_law = coupling::TermLaw::brittle();

  bool operator==(const Material&) const = default;

  // Throws Error (argument) for values that no material has.
  void check() const;

  // Infinite for a material that does not break. `as_printed`: with the constant of Yang and Liu 2021, Eq. 15.
  double critical_stretch_for(double horizon, bool as_printed) const;
};

}  // namespace bempd::scene

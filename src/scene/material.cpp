#include "scene/material.hpp"

#include <cmath>
#include <limits>

#include "error.hpp"
#include "pd/cell_squares.hpp"
#include "pd/critical_stretch.hpp"

namespace bempd::scene {

namespace {

// Smallest and largest value accepted for Young's modulus and for its product with the thickness. They are so far from
// the ends of the number range that products and ratios of stiffnesses stay within that range.
constexpr double softest = 1e-200, stiffest = 1e200;

bool is_in_range(double stiffness) { return stiffness >= softest && stiffness <= stiffest; }

}  // namespace

void Material::check() const {
  const PlaneElasticity& e = elasticity;
  require(std::isfinite(e.young_modulus) && e.young_modulus > 0, "young_modulus is ", e.young_modulus,
          "; it must be > 0");
  require(std::isfinite(e.poisson_ratio) && e.poisson_ratio > -1 && e.poisson_ratio <= 0.5, "poisson_ratio is ",
          e.poisson_ratio, "; it must be above -1 and at most 1/2");
  require(std::isfinite(e.thickness) && e.thickness > 0, "thickness is ", e.thickness, "; it must be > 0");
  require(is_in_range(e.young_modulus) && is_in_range(e.young_modulus * e.thickness), "young_modulus is ",
          e.young_modulus, " and thickness ", e.thickness, "; the modulus and its product with the thickness must lie ",
          "between 1e-200 and 1e200; choose other units");
  require(std::isfinite(critical_stretch) && critical_stretch >= 0, "critical_stretch is ", critical_stretch,
          "; it must be > 0, or 0 for not given");
  require(std::isfinite(fracture_energy) && fracture_energy >= 0, "fracture_energy is ", fracture_energy,
          "; it must be > 0, or 0 for not given");
  require(std::isfinite(thermal_expansion), "thermal_expansion is ", thermal_expansion, "; it must be a finite number");
  require(critical_stretch == 0 || fracture_energy == 0,
          "both critical_stretch and fracture_energy are given; give one and set the other to 0");
}

double Material::critical_stretch_for(double horizon, bool as_printed) const {
  if (critical_stretch > 0) return critical_stretch;
  if (fracture_energy > 0) {
    if (as_printed) {
      require(
          elasticity.state == PlaneState::stress,
          "the option critical_stretch = printed stands for a formula of plane stress; choose exact in plane strain");
      require(pd::is_bond_based(elasticity),
              "the option critical_stretch = printed stands for a formula of Poisson's ratio 1/3, and a material has ",
              elasticity.poisson_ratio, "; choose exact");
      return pd::printed_critical_stretch(fracture_energy, elasticity.young_modulus, horizon);
    }
    return pd::critical_stretch(fracture_energy, elasticity, horizon);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace bempd::scene

#pragma once

#include <cmath>
#include <limits>

#include "crack/factors.hpp"
#include "crack/laws/host_resistance.hpp"
#include "crack/laws/resistance_directions.hpp"
#include "elasticity/kinked_tip.hpp"

namespace bempd::crack {

// Range of load factors in which a tip does not grow; infinite where there is no bound.
struct GrowthRange {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();

  bool is_empty() const { return lowest > highest; }  // true: the tip grows at every load factor
  bool holds(double load_factor) const { return lowest < load_factor && load_factor < highest; }
};

// Growth law of a tip at its present place: the criterion for kinks, and the properties of the material around the tip.
struct GrowthLaw {
  double toughness = 0;      // K_I at which the tip grows straight on; 0 or infinite: no growth [Pa m^(1/2)]
  double plane_modulus = 0;  // E, in plane strain E / (1 - nu^2) [Pa]
  KinkCriterion criterion = KinkCriterion::hoop_stress;
  // Table of fracture energies by the direction of growth, as shares of the material's fracture energy; null if
  // directions do not matter. With a table, `toughness` belongs to a direction with the share 1.
  const ResistanceDirections* directions = nullptr;
  double heading = 0;  // direction of the crack from the x axis [rad]
  // Data for the host's function of the fracture energy. If there is such a function, `toughness` is only the value
  // with which a search for the load of growth begins.
  AskingTip asking{};

  // Law with the toughness that the host's function gives for these stress intensity factors; the law itself if the
  // host gave no function.
  GrowthLaw with_host_toughness(const Point& factors, double t_stress) const;
  GrowthLaw with_host_toughness(const AffineFactors& factors, double load_factor) const {
    return asking.function ? with_host_toughness(factors.at(load_factor), asking.t_stress.dot(Point(1, load_factor)))
                           : *this;
  }

  double share_in(double angle) const { return directions ? directions->share(heading + angle) : 1; }
  // Energy that growth at an angle takes per new crack area [J/m^2].
  double resistance(double angle = 0) const { return toughness * toughness / plane_modulus * share_in(angle); }
  // Energy release rate when the tip grows in the direction of a kink [J/m^2].
  double rate(const Kink& kink) const {
    return kink.equivalent_factor * kink.equivalent_factor / plane_modulus * share_in(kink.angle);
  }

  Kink kink(const Point& factors) const {
    return directions ? directions->kink(factors, heading, criterion) : kink_of(factors, criterion);
  }
  Kink kink(const AffineFactors& factors, double load_factor) const { return kink(factors.at(load_factor)); }
  // Ratio of the equivalent factor (stress intensity factor of mode I in the direction of growth) to the toughness at a
  // load factor. The tip grows when this ratio reaches 1.
  double ratio(const AffineFactors& factors, double load_factor) const {
    if (!(toughness > 0)) return 0;
    return kink(factors, load_factor).equivalent_factor / with_host_toughness(factors, load_factor).toughness;
  }
  // Range of load factors in which ratio() is below 1; unbounded if the toughness is infinite or not positive (no
  // fracture). By the hoop stress criterion the equivalent factor is a maximum of functions linear in the load factor,
  // so the range is an interval. By the energy release rate this holds unless kinks close, and a function of the host
  // may have any form: the range is then the interval around the load factor 0, or around the load factor with the
  // least ratio by hoop stress.
  GrowthRange range(const AffineFactors& factors) const;
  // Smallest load factor >= 0 at which ratio() is 1 or more; infinite if there is none.
  double first_load_factor(const AffineFactors& factors) const;
};

// Toughness (K_I at which a crack grows straight on) of a material with this fracture energy [J/m^2] and plane modulus.
inline double toughness_of(double fracture_energy, double plane_modulus) {
  return std::sqrt(plane_modulus * fracture_energy);
}

}  // namespace bempd::crack

#pragma once

#include "crack/carrier.hpp"
#include "fracture/line/line_path.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Next step of the tip of a crack line (crack that grows in a lattice by steps).
struct LineStep {
  std::size_t tip = 0;  // number of the tip in the list of tips
  crack::TipId id{};
  Point direction{1, 0};
  LinePath::Step path{};
  double load_factor = 0;            // critical load factor
  double constant = 0, growing = 0;  // ratio of intensity to toughness, corrected: see ratio_at()
  int law = 0;                       // number of the tip law
  double angle = 0;                  // turn of the tip, counter-clockwise [rad]
  crack::AffineFactors factors{};    // stress intensity factors of the tip

  // Whether the fit of stresses gives the load, because the field ahead is that of the tip alone.
  bool fit_holds = true, is_shut = false;  // shut: the faces press on each other at the tip
  // Relative error of the load, and residual of the fit as a share of the stress.
  double error = 0, residual = 0;
  // Use of path-independent sums around the tip. `asks_for_sums`: factors, direction and load are taken from the sums
  // if there is room for them. `sums_suffice`: their load needs no trial step in addition. `load_by_sums`: the load
  // comes from the sums.
  bool asks_for_sums = false, sums_suffice = true, load_by_sums = false;
  // Properties of the fit. `at_border`: it lacks points beside a border with boundary elements.
  // `fit_holds_without_sums`: it gives the load if the sums do not.
  bool at_border = false, fit_holds_without_sums = true;
  // Square of the ratio of the intensity by the sums to that of the fit; 1 if the load is not by the sums.
  double rate_over_fit = 1;
  // Whether the load is a mean of the load by the fit (or by the sums) and of the load by a trial step, as for a
  // sheared tip with no other tip near.
  bool averages_loads = false;
  // Whether the load comes from the energy of a trial step.
  bool load_by_trial = false;
  double toughness = 0;  // by a function of the host, at the critical load factor; 0 without one [Pa m^(1/2)]
  // Ratio of ratio_at() after a trial step to that before it; and energy that the bonds of the step take, 0 if unknown
  // [J].
  double after_step = 1, taken_energy = 0;
  bool is_loaded = true;  // whether the tip bears a load at this load factor; false only for steps in a given direction

  // Ratio of the equivalent stress intensity factor to the toughness at a load factor.
  double ratio_at(double at) const { return constant + at * growing; }
};

}  // namespace bempd::fracture

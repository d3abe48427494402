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

  // Whether the fit of stresses gives the load factor, because the stress field ahead is that of the tip alone.
  bool fit_holds = true, is_shut = false;  // shut: the faces press on each other at the tip
  // Relative error of the load factor, and residual of the fit of stresses as a share of the stress.
  double error = 0, residual = 0;
  // Use of path-independent sums around the tip, which give its stress intensity factors. `asks_for_sums`: factors,
  // direction and load factor are taken from the sums if there is room for them. `sums_suffice`: a load factor from the
  // sums needs no trial step in addition. `load_by_sums`: the load factor has been taken from the sums.
  bool asks_for_sums = false, sums_suffice = true, load_by_sums = false;
  // Properties of the fit of stresses. `at_border`: the fit lacks points beside a border with boundary elements.
  // `fit_holds_without_sums`: if the sums around the tip find no room, the load factor of the fit is used.
  bool at_border = false, fit_holds_without_sums = true;
  // Ratio of energy release rates, of the rate by the sums around the tip to the rate by the fit; 1 if the load factor
  // does not come from the sums.
  double rate_over_fit = 1;
  // Whether the load factor is a mean: of that by the fit (or by the sums) and of that by a trial step, as for a tip
  // under shear with no other tip near.
  bool averages_loads = false;
  // Whether the load factor comes from the energy of a trial step (evaluated but not taken).
  bool load_by_trial = false;
  double toughness = 0;  // by a function of the host, at the critical load factor; 0 without one [Pa m^(1/2)]
  // Change of ratio_at() by a trial step: value after the step over value before (`after_step`). Energy that the bonds
  // of the step take [J]; 0 if unknown (`taken_energy`).
  double after_step = 1, taken_energy = 0;
  bool is_loaded = true;  // whether the tip bears a load at this load factor; false only for steps in a given direction

  // Ratio of the equivalent stress intensity factor to the toughness at a load factor.
  double ratio_at(double at) const { return constant + at * growing; }
};

}  // namespace bempd::fracture

#pragma once

#include "crack/carrier.hpp"
#include "fracture/line/line_path.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Next step of a tip.
struct LineStep {
  std::size_t tip = 0;
  crack::TipId id{};  // of the tip
  Point direction{1, 0};
  LinePath::Step path{};
  double load_factor = 0;            // critical
  double constant = 0, growing = 0;  // hoop intensity there, over the toughness, corrected
  int law = 0;                       // by which it grows
  double angle = 0;                  // by which it turns, counter-clockwise
  crack::AffineFactors factors{};    // of the tip

  // Whether the fit gives the load, because the field ahead is that of the tip alone. Then the relative error of the
  // load, and the residual of the fit as a share of the stress.
  bool fit_holds = true, is_shut = false;  // shut: its faces press on each other at the tip
  double error = 0, residual = 0;
  // Sums around the tip: whether they are asked for its factors, direction and load; whether their load then stands
  // without that of an energy; and whether the load is theirs (`load_by_sums`: there was room for them). `at_border`:
  // the fit lacks points beside a border with boundary elements. `fit_holds_without_sums`: it holds if no sums are
  // asked for. `rate_over_fit`: if by factors, the square of their ratio to those of the fit.
  bool asks_for_sums = false, sums_suffice = true, load_by_sums = false;
  bool at_border = false, fit_holds_without_sums = true;
  double rate_over_fit = 1;
  // Whether the load by the fit counts beside that by an energy: for a sheared tip with no other tip near.
  bool averages_loads = false;
  // Whether the load comes from the energy of a trial step. If so: the ratio (see ratio_at) after the step over that
  // before it, and the energy that the step's bonds take [J].
  bool load_by_trial = false;
  double toughness = 0;  // at that load factor by a function of the host; 0 without one [Pa m^(1/2)]
  double after_step = 1, taken_energy = 0;
  bool is_loaded = true;  // the tip bears a load at the step's load factor; false only for steps in a given direction

  double ratio_at(double at) const { return constant + at * growing; }
};

}  // namespace bempd::fracture

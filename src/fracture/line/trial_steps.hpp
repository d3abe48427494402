#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_load.hpp"
#include "fracture/line/line_path.hpp"
#include "fracture/line/trial_energy.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Stiffness that a crack cuts, as a measure of its length. A straight crack in an infinite lattice cuts a certain
// stiffness per unit of length, so that the stiffness that a step cuts gives the effective length of the step. The
// number of bonds cut would be a poor measure, because it varies a lot from one spacing to the next.
class CutStiffness {
 public:
  CutStiffness(const coupling::Terms& terms, const pd::TipLaws& laws);

  // Crack length [m] that the cut of one bond stands for on a crack with the unit normal `normal`, and the fracture
  // energy [J] of this length. One half of each follows from the lattice at one end of the bond, the other half from
  // the lattice at the other end.
  struct Counted {
    double length = 0, energy = 0;
  };
  Counted of(std::size_t bond, double stiffness, const Point& normal) const;

  // Effective stiffness of a bond that the end of an initial crack has weakened to `stiffness`. Removing half of a
  // bond's stiffness releases less than half of the energy that removing the whole bond would release.
  double effective_stiffness_of_weakened(std::size_t bond, double stiffness) const;

 private:
  struct Bond {
    Point vector;  // between the points of the bond
    double stiffness;
  };
  static std::vector<Bond> family_of(const coupling::Terms& terms, const std::vector<double>& whole,
                                     const std::vector<int>& points, const linalg::Adjacency& bonds_at, double same);
  double per_length(int law, const Point& normal) const;

  const coupling::Terms& terms_;
  const pd::TipLaws& laws_;
  std::vector<std::vector<Bond>> family_;  // bonds of a point deep inside the lattice, for every law
};

// Ratio of the energy that straight growth in one direction would release to the energy that the growth would take: for
// lengths of one to several spacings, and extrapolated to the length 0.
class TrialGrowth {
 public:
  struct Length {
    Eigen::Index terms;
    double length, energy;  // effective length [m], and energy that the growth takes [J]
  };

  // Trial growth by the given lengths. `opening` holds weights: if the sum of the terms' elongations after the growth,
  // times these weights, is positive, the growth opens the crack.
  TrialGrowth(TrialEnergy energy, std::vector<Length> lengths, Eigen::VectorXd opening)
      : energy_(std::move(energy)), lengths_(std::move(lengths)), opening_(std::move(opening)) {}

  // Square root of the ratio of the energy release rate at the tip to the fracture energy.
  double ratio(double load_factor) const { return at_tip(load_factor).ratio; }
  // Value of ratio() that is expected after the tip has grown by the first trial length.
  double ratio_after(double load_factor) const { return at_tip(load_factor).ratio_after; }
  // Relative error of ratio(), from the scatter of the energy release rates of the trial lengths about the fitted
  // curve.
  double error(double load_factor) const { return at_tip(load_factor).error; }
  // Square root of the ratio of released to taken energy over the longest trial length. It depends less on single bonds
  // than ratio() does.
  double mean_ratio(double load_factor) const;
  // Whether the step opens the crack: after the step the bonds across it would be longer than their unstressed length,
  // on the whole.
  bool opens(double load_factor) const;
  // Energy [J] that growth by the first, shortest trial length takes.
  double first_energy() const { return lengths_.front().energy; }
  // Sets how the energy release rate changes with the distance along a kink.
  void shape(const KinkShape& kink) { kink_ = kink; }

  // Load factor at which ratio() reaches one, so that the tip grows, and the slope of the ratio there; found by an
  // iteration from `nearby`. `sense` is the sign of the load path (1 or -1); `proportional` says that there are no
  // constant loads. Empty if the ratio does not rise on the path, if the bonds across the step bear nothing, or if the
  // step does not open the crack (opens()).
  std::optional<LineLoad> load(double nearby, double sense, bool proportional) const;

 private:
  struct AtTip {
    double ratio, ratio_after, error;
  };
  AtTip at_tip(double load_factor) const;

  TrialEnergy energy_;
  std::vector<Length> lengths_;
  Eigen::VectorXd opening_;
  KinkShape kink_;
};

// Trial steps (evaluated but not taken) of the tips of crack lines, whose critical load factors follow from the energy
// that the steps release. They are used where the field ahead of a tip is not its own singular field, but disturbed by
// an edge, a face or another tip.
class TrialSteps {
 public:
  TrialSteps(const coupling::EquilibriumSystem& system, const pd::TipLaws& laws, const LinePath& path);

  // Trial step of a tip in a direction; empty if no bond lies ahead, or if `body` cannot give the flexibility of the
  // bonds.
  std::optional<TrialGrowth> along(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction,
                                   const coupling::Affine& displacement, TrialBody& body) const;

  // Energy [J] that a step of one spacing takes, from the stiffness that it cuts (CutStiffness); 0 if that is not
  // finite.
  double energy_of_step(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction) const;

  // Direction in which growth by some spacings has the largest ratio of released to taken energy, among directions on
  // both sides of `around`.
  Point best_direction(const GrowingTip& tip, const pd::TipLaw& law, const Point& around, double load_factor,
                       const coupling::Affine& displacement, TrialBody& body) const;

 private:
  CutStiffness::Counted counted(const GrowingTip& tip, int bond, const Point& normal) const;

  const coupling::EquilibriumSystem& system_;
  const LinePath& path_;
  CutStiffness cut_;
};

}  // namespace bempd::fracture

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
// stiffness for each length, so that the stiffness that a step cuts gives the effective length of the step. The number
// of bonds cut varies a lot from one spacing to the next.
class CutStiffness {
 public:
  CutStiffness(const coupling::Terms& terms, const pd::TipLaws& laws);

  // Crack length [m] that the cut of one bond stands for on a crack with the unit normal `normal`, and the fracture
  // energy [J] of this length. The lattices at the two ends of the bond determine half of each.
  struct Counted {
    double length = 0, energy = 0;
  };
  Counted of(std::size_t bond, double stiffness, const Point& normal) const;

  // Effective stiffness of a bond that is weakened at the end of an initial crack: removing half of a bond releases
  // less than half of the energy that the whole bond would release.
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

// Ratio of the energy that straight growth in one direction would release to the energy that it would take: for lengths
// of one to several spacings, and extrapolated to the tip.
class TrialGrowth {
 public:
  struct Length {
    Eigen::Index terms;
    double length, energy;  // effective length [m], and energy that the growth takes [J]
  };

  // Trial growth by the given lengths. `opening` holds the weights of the terms' elongations in a sum whose sign says
  // whether a step opens or closes the crack.
  TrialGrowth(TrialEnergy energy, std::vector<Length> lengths, Eigen::VectorXd opening)
      : energy_(std::move(energy)), lengths_(std::move(lengths)), opening_(std::move(opening)) {}

  // Square root of the ratio of the energy release rate at the tip to the rate that growth takes.
  double ratio(double load_factor) const { return at_tip(load_factor).ratio; }
  // Ratio as ratio() gives it, but after growth by the first trial length.
  double ratio_after(double load_factor) const { return at_tip(load_factor).ratio_after; }
  // Relative error of ratio(), from the scatter of the rates of the trial lengths about the line fitted to them.
  double error(double load_factor) const { return at_tip(load_factor).error; }
  // Square root of the ratio of released to taken energy over the longest trial length, which depends less on single
  // bonds than ratio().
  double mean_ratio(double load_factor) const;
  // Whether the step opens the crack: the bonds across the whole step are on the whole longer after it than before.
  bool opens(double load_factor) const;
  // Energy [J] that growth takes by the first, shortest one of the trial lengths.
  double first_energy() const { return lengths_.front().energy; }
  // Sets the change of the energy release rate behind a kink.
  void shape(const KinkShape& kink) { kink_ = kink; }

  // Load factor at which ratio() reaches one, so that the tip grows, and the slope of the ratio there; found by an
  // iteration from `nearby`. `sense` is the sign of the load path; `proportional` says that there are no constant
  // loads. Empty if the ratio does not rise on the path, or if the bonds across the step bear nothing or would become
  // shorter (opens()).
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

// Trial steps (evaluated but not taken) of the tips of crack lines, whose loads follow from the energy that the steps
// release. They are used where the field ahead of a tip is not its own singular field, but disturbed by an edge, a face
// or another tip.
class TrialSteps {
 public:
  TrialSteps(const coupling::EquilibriumSystem& system, const pd::TipLaws& laws, const LinePath& path);

  // Trial step of a tip in a direction; empty if no bond lies ahead, or if the body has no answer.
  std::optional<TrialGrowth> along(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction,
                                   const coupling::Affine& displacement, TrialBody& body) const;

  // Energy [J] that a step of one spacing takes, by the stiffness that it cuts (CutStiffness); 0 if it is not finite.
  double energy_of_step(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction) const;

  // Direction of the largest energy release rate over some spacings, among directions on both sides of `around`.
  Point best_direction(const GrowingTip& tip, const pd::TipLaw& law, const Point& around, double load_factor,
                       const coupling::Affine& displacement, TrialBody& body) const;

 private:
  CutStiffness::Counted counted(const GrowingTip& tip, int bond, const Point& normal) const;

  const coupling::EquilibriumSystem& system_;
  const LinePath& path_;
  CutStiffness cut_;
};

}  // namespace bempd::fracture

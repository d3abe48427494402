#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_load.hpp"
#include "fracture/line/line_way.hpp"
#include "fracture/line/trial_energy.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// A straight crack in an endless lattice takes bonds of a certain stiffness for each length. What a step cuts of that
// stiffness counts as its length: bonds come one by one, and from one spacing to the next by quite different numbers.
class CutStiffness {
 public:
  CutStiffness(const coupling::Terms& terms, const std::vector<Point>& positions, const pd::TipLaws& laws);

  // Length [m] and energy [J] of a bond across a line with this unit normal, half by the lattice at either end.
  struct Counted {
    double length = 0, energy = 0;
  };
  Counted of(std::size_t bond, double stiffness, const Point& normal) const;

  // Stiffness that a bond counts by which is weakened at the end of an initial crack. Half a bond that is taken away
  // releases less than half of what the whole bond does.
  double left_of_weakened(std::size_t bond, double stiffness) const;

 private:
  struct Bond {
    Point vector;  // between its points
    double stiffness;
  };
  static std::vector<Bond> family_of(const coupling::Terms& terms, const std::vector<double>& whole,
                                     const std::vector<int>& points, const linalg::Adjacency& bonds_at, double same);
  double per_length(int law, const Point& normal) const;

  const coupling::Terms& terms_;
  const pd::TipLaws& laws_;
  std::vector<std::vector<Bond>> family_;  // of a point deep inside, for every law
};

// What growth straight on in one direction would release, over what it would take: for one to some spacings, and from
// there at the tip itself.
class TrialGrowth {
 public:
  struct Length {
    Eigen::Index terms;
    double length, energy;  // counted [m], and taken [J]
  };

  // `opening`: weights of the terms' elongations in what tells whether a step opens or closes.
  TrialGrowth(TrialEnergy energy, std::vector<Length> lengths, Eigen::VectorXd opening)
      : energy_(std::move(energy)), lengths_(std::move(lengths)), opening_(std::move(opening)) {}

  // Root of the energy release rate at the tip over what growth takes, and the same after the first length.
  double ratio(double load_factor) const { return at_tip(load_factor).ratio; }
  double ratio_after(double load_factor) const { return at_tip(load_factor).ratio_after; }
  // Error of the ratio, from the scatter of the lengths about their line.
  double error(double load_factor) const { return at_tip(load_factor).error; }
  // Mean of the ratio over all lengths; longer lengths depend less on single bonds.
  double mean_ratio(double load_factor) const;
  // Whether bonds across the whole step get longer rather than shorter once it is made.
  bool opens(double load_factor) const;
  // What the first length takes [J].
  double first_energy() const { return lengths_.front().energy; }
  // Sets the rate's shape behind a kink.
  void shape(const KinkShape& kink) { kink_ = kink; }

  // Load factor at which the ratio reaches one, searched from a load factor nearby, and how it grows there; null where
  // it does not rise on the way, or the step would close.
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

// Steps of tips that are tried out by their energy, where the stress ahead is not the tip's own.
class TrialSteps {
 public:
  TrialSteps(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const pd::TipLaws& laws,
             const LineWay& way);

  // Null where no bond lies ahead or the body cannot tell.
  std::optional<TrialGrowth> along(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction,
                                   const coupling::Affine& displacement, TrialBody& body) const;

  // The direction of the largest energy release rate over some spacings, among some on both sides of this one.
  Point best_direction(const GrowingTip& tip, const pd::TipLaw& law, const Point& around, double load_factor,
                       const coupling::Affine& displacement, TrialBody& body) const;

 private:
  const coupling::EquilibriumSystem& system_;
  const LineWay& way_;
  CutStiffness cut_;
};

}  // namespace bempd::fracture

#pragma once

#include <vector>

#include "elasticity/kinked_tip.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// Fracture energy by the direction of growth (grain, layers or weak planes), in shares of the material's fracture
// energy. The share is linear in the angle between the rows of a table. A direction and its opposite have the same
// share.
class ResistanceDirections {
 public:
  // `angles`: from the x axis, counter-clockwise and ascending, within half a turn [rad]; `shares` > 0.
  ResistanceDirections(std::vector<double> angles, std::vector<double> shares);

  double share(double angle) const;
  double smallest_share() const;

  // Kink of a tip with the stress intensity factors `factors` (K_I, K_II), whose crack runs in the direction `heading`
  // [rad]: the angle with the largest ratio of energy release rate to fracture energy. `criterion` defines the energy
  // release rate at an angle. The result's equivalent factor is divided by the root of the share of fracture energy at
  // that angle, so that it is compared with the toughness for the share 1.
  Kink kink(const Point& factors, double heading, KinkCriterion criterion) const;

  bool operator==(const ResistanceDirections&) const = default;
  const std::vector<double>& angles() const { return angles_; }
  const std::vector<double>& shares() const { return shares_; }

 private:
  std::vector<double> trial_angles(double heading) const;

  std::vector<double> angles_, shares_;
};

}  // namespace bempd::crack

#pragma once

#include <vector>

#include "elasticity/kinked_tip.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// Fracture energy by the direction in which a crack runs, in shares of the material's fracture energy: of grain, layers
// or weak planes. A direction and its opposite are the same. It is linear between the rows of a table.
class ResistanceDirections {
 public:
  // `angles`: from the x axis, counter-clockwise and ascending, within half a turn [rad]; `shares` > 0.
  ResistanceDirections(std::vector<double> angles, std::vector<double> shares);

  double share(double angle) const;
  double smallest_share() const;

  // Kink of a tip with the factors (K_I, K_II), whose crack runs in the direction `heading` [rad]: the largest ratio of
  // the energy release rate to the fracture energy, where the criterion says what that rate is. The equivalent factor
  // is that of a tip which meets the material's own fracture energy.
  Kink kink(const Point& factors, double heading, KinkCriterion criterion) const;

  bool operator==(const ResistanceDirections&) const = default;
  const std::vector<double>& angles() const { return angles_; }
  const std::vector<double>& shares() const { return shares_; }

 private:
  std::vector<double> trial_angles(double heading) const;

  std::vector<double> angles_, shares_;
};

}  // namespace bempd::crack

#pragma once

#include <cmath>
#include <limits>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// One cycle of the loads at a tip. Its equivalent factors are those of mode I in the direction in which the tip grows.
struct TipCycle {
  TipId tip;
  Point high{0, 0}, low{0, 0};     // K_I and K_II at the highest and the lowest load of the cycle [Pa m^(1/2)]
  double highest = 0, lowest = 0;  // equivalent factors there [Pa m^(1/2)]
  double length = 0;               // of the crack [m]
  Point place{0, 0};               // of the tip [m]

  double range() const { return highest - lowest; }
  double ratio() const { return lowest / highest; }  // R
};

// How far a tip grows in a cycle, below the load at which it breaks.
class RateLaw {
 public:
  // `threshold`: range up to which the tip does not grow; `critical`: highest factor at which it breaks, infinite if
  // nothing is known of it [Pa m^(1/2)].
  RateLaw(double threshold, double critical) : threshold_(threshold), critical_(critical) {}
  RateLaw(const RateLaw&) = delete;
  RateLaw& operator=(const RateLaw&) = delete;
  virtual ~RateLaw() = default;

  double critical() const { return critical_; }
  // Growth in a cycle [m], or in a unit of time. A tip whose faces are pressed together does not grow.
  double rate(const TipCycle& cycle) const {
    if (!(cycle.highest > 0) || !(cycle.range() > threshold_)) return 0;
    return growth(cycle);
  }

 protected:
  virtual double growth(const TipCycle& cycle) const = 0;
  double threshold() const { return threshold_; }

 private:
  double threshold_, critical_;
};

}  // namespace bempd::crack

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "crack/laws/tip_cycle.hpp"

namespace bempd::crack {

// Plastic zone ahead of a tip, left by the largest load that the tip has met. Growth is measured from the beginning of
// a step.
struct Overload {
  double end = -std::numeric_limits<double>::infinity();  // growth of the tip at which the zone ends [m]
  double zone = 0;                                        // size of the zone [m]
  double highest = 0;  // equivalent factor of the load that left the zone [Pa m^(1/2)]
};

// Retardation: slower growth in the plastic zone of an earlier, higher load. A load with the equivalent factor K has a
// plastic zone of the size (K / yield strength)^2 / (pi constraint), with the constraint 2 in plane stress and 6 in
// plane strain.
class Retardation {
 public:
  Retardation(double yield_strength, double constraint) : yield_strength_(yield_strength), constraint_(constraint) {}
  Retardation(const Retardation&) = delete;
  Retardation& operator=(const Retardation&) = delete;
  virtual ~Retardation() = default;

  double zone(double highest) const {
    const double ratio = std::max(0.0, highest) / yield_strength_;
    return ratio * ratio / (constraint_ * std::numbers::pi);
  }
  // Overload after a cycle with the highest equivalent factor `highest`, at a tip that has grown by `grown`: the
  // plastic zone of this cycle if it reaches at least as far as the zone of `before`, else `before`.
  Overload after(const Overload& before, double grown, double highest) const {
    const double own = zone(highest);
    return grown + own >= before.end ? Overload{grown + own, own, highest} : before;
  }
  // Whether an overload slows the tip down in a cycle: its plastic zone reaches farther than the zone of the cycle,
  // which has the highest equivalent factor `highest`. `grown` is the growth of the tip since the beginning of the
  // step.
  bool acts(const Overload& overload, double grown, double highest) const {
    return grown + zone(highest) < overload.end;
  }

  // Retarded growth: inside the plastic zone of an overload a tip grows by `share` times the growth that the law gives
  // for `cycle`.
  struct Reduced {
    TipCycle cycle;
    double share = 1;
  };
  // Retarded growth in a cycle inside the plastic zone of an overload, of a tip that has grown by `grown` since the
  // beginning of the step.
  virtual Reduced reduced(const TipCycle& cycle, const Overload& overload, double grown) const = 0;

 private:
  double yield_strength_, constraint_;
};

// Wheeler, J. Basic Eng. 94, 1972: the growth rate is multiplied by a power of the ratio of the size of the cycle's
// plastic zone to the distance from the tip to the end of the overload's zone.
class Wheeler final : public Retardation {
 public:
  Wheeler(double yield_strength, double constraint, double exponent)
      : Retardation(yield_strength, constraint), exponent_(exponent) {}

  Reduced reduced(const TipCycle& cycle, const Overload& overload, double grown) const override {
    return {cycle, std::pow(zone(cycle.highest) / (overload.end - grown), exponent_)};
  }

 private:
  double exponent_;
};

// Willenborg, Engle and Wood, AFFDL-TM-71-1-FBR, 1971, generalized by Gallagher: the largest and the least equivalent
// factor of a cycle, K_max and K_min, are reduced by phi [K_overload sqrt(distance from the tip to the end of the
// overload's zone / size of that zone) - K_max], if that is positive, with phi = (1 - dK_th / K_max) / (shut-off ratio
// - 1). K_overload is the equivalent factor of the overload, dK_th the threshold of the range. A tip stops if
// K_overload / K_max is the shut-off ratio. The reduction acts through the load ratio K_min / K_max only, so the growth
// law must depend on it.
class Willenborg final : public Retardation {
 public:
  Willenborg(double yield_strength, double constraint, double threshold, double shutoff_ratio)
      : Retardation(yield_strength, constraint), threshold_(threshold), shutoff_ratio_(shutoff_ratio) {}

  Reduced reduced(const TipCycle& cycle, const Overload& overload, double grown) const override {
    if (cycle.highest <= threshold_) return {cycle, 0};
    const double needed = overload.highest * std::sqrt((overload.end - grown) / overload.zone);
    const double share = (1 - threshold_ / cycle.highest) / (shutoff_ratio_ - 1);
    const double reduction = share * std::max(0.0, needed - cycle.highest);
    TipCycle slower = cycle;
    slower.highest -= reduction, slower.lowest -= reduction;
    return {slower, 1};
  }

 private:
  double threshold_, shutoff_ratio_;
};

}  // namespace bempd::crack

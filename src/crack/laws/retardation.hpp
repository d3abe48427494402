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

// Retardation: slower growth in the plastic zone of an earlier, higher load. The size of a load's zone is (K / yield
// strength)^2 / (pi constraint), with the constraint 2 in plane stress and 6 in plane strain.
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
  // Overload after a cycle of a tip that has grown by `grown`: the zone of this cycle if it reaches at least as far as
  // the zone of `before`, else `before`.
  Overload after(const Overload& before, double grown, double highest) const {
    const double own = zone(highest);
    return grown + own >= before.end ? Overload{grown + own, own, highest} : before;
  }
  // Whether the plastic zone of an overload reaches beyond the zone of a cycle.
  bool acts(const Overload& overload, double grown, double highest) const {
    return grown + zone(highest) < overload.end;
  }

  // Cycle and factor that describe retardation: inside the zone of an overload a tip grows by `share` times its rate in
  // `cycle`.
  struct Reduced {
    TipCycle cycle;
    double share = 1;
  };
  // Retarded growth in a cycle; `grown` is as in acts().
  virtual Reduced reduced(const TipCycle& cycle, const Overload& overload, double grown) const = 0;

 private:
  double yield_strength_, constraint_;
};

// Wheeler, J. Basic Eng. 94, 1972: the rate is multiplied by a power of the ratio of the cycle's zone to the distance
// to the end of the overload's zone.
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

// Willenborg, Engle and Wood, AFFDL-TM-71-1-FBR, 1971, generalized by Gallagher: both factors of a cycle are reduced by
// phi [K_overload sqrt(distance to the end of the overload's zone / size of that zone) - K_max] with phi = (1 - dK_th /
// K_max) / (shut-off ratio - 1). A tip stops if K_overload / K_max is the shut-off ratio. The reduction acts through
// the load ratio R only, so the growth law must depend on R.
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

#pragma once

#include <memory>

#include "crack/laws/retardation.hpp"
#include "crack/laws/tip_cycle.hpp"

namespace bempd::crack {

// Law of crack growth per load cycle, for loads below the load at which the tip breaks.
class RateLaw {
 public:
  // `threshold`: range dK up to which the tip does not grow [Pa m^(1/2)].
  explicit RateLaw(double threshold) : threshold_(threshold) {}
  RateLaw(const RateLaw&) = delete;
  RateLaw& operator=(const RateLaw&) = delete;
  virtual ~RateLaw() = default;

  // Growth in one cycle [m], or in a unit of time. A tip whose faces are pressed together does not grow.
  double rate(const TipCycle& cycle) const {
    if (!(cycle.highest > 0) || !(cycle.range() > threshold_)) return 0;
    return growth(cycle);
  }
  // Growth in one cycle [m] of a tip that has grown by `grown` since the beginning of the step. Retardation slows the
  // growth down in the plastic zone of an overload.
  double rate(const TipCycle& cycle, const Overload& overload, double grown) const {
    if (!retardation_ || !retardation_->acts(overload, grown, cycle.highest)) return rate(cycle);
    const Retardation::Reduced reduced = retardation_->reduced(cycle, overload, grown);
    return reduced.share > 0 ? reduced.share * rate(reduced.cycle) : 0;
  }

  // Retardation by earlier loads; null: earlier loads have no effect.
  const Retardation* retardation() const { return retardation_.get(); }
  void slow_down(std::unique_ptr<Retardation> retardation) { retardation_ = std::move(retardation); }

 protected:
  virtual double growth(const TipCycle& cycle) const = 0;
  double threshold() const { return threshold_; }

 private:
  double threshold_;
  std::unique_ptr<Retardation> retardation_;
};

}  // namespace bempd::crack

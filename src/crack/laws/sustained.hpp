#pragma once

#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Growth in time under a sustained load, as in stress corrosion: velocity v = C K^n if the stress intensity factor K
// exceeds a threshold, else 0; C and n are material constants. One cycle stands for a unit of time at the cycle's
// highest load.
class Sustained final : public RateLaw {
 public:
  Sustained(double coefficient, double exponent, double threshold)
      : RateLaw(-std::numeric_limits<double>::infinity()),
        coefficient_(coefficient),
        exponent_(exponent),
        least_(threshold) {}

 private:
  double growth(const TipCycle& cycle) const override {
    return cycle.highest > least_ ? coefficient_ * std::pow(cycle.highest, exponent_) : 0;
  }

  double coefficient_, exponent_, least_;
};

}  // namespace bempd::crack

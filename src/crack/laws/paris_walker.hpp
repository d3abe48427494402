#pragma once

#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Paris and Erdogan, J. Basic Eng. 85, 1963, with the load ratio R = K_min / K_max as in Walker, ASTM STP 462, 1970:
// growth per cycle da/dN = C [(1 - R)^(gamma - 1) dK]^m, with the range dK = K_max - K_min and material constants C, m
// and gamma. With gamma = 1, R has no effect.
class ParisWalker final : public RateLaw {
 public:
  ParisWalker(double coefficient, double exponent, double walker, double threshold)
      : RateLaw(threshold), coefficient_(coefficient), exponent_(exponent), walker_(walker) {}

 private:
  double growth(const TipCycle& cycle) const override {
    const double of_ratio = walker_ == 1 ? 1 : std::pow(1 - cycle.ratio(), walker_ - 1);
    return coefficient_ * std::pow(of_ratio * cycle.range(), exponent_);
  }

  double coefficient_, exponent_, walker_;
};

}  // namespace bempd::crack

#pragma once

#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Forman, Kearney and Engle, J. Basic Eng. 89, 1967: growth per cycle da/dN = C dK^m / ((1 - R) K_c - dK), with the
// range dK = K_max - K_min, the load ratio R = K_min / K_max, the toughness K_c, and material constants C and m. The
// rate is unbounded where K_max reaches K_c.
class Forman final : public RateLaw {
 public:
  Forman(double coefficient, double exponent, double threshold)
      : RateLaw(threshold), coefficient_(coefficient), exponent_(exponent) {}

 private:
  double growth(const TipCycle& cycle) const override {
    const double left = (1 - cycle.ratio()) * cycle.critical - cycle.range();
    return coefficient_ * std::pow(cycle.range(), exponent_) / left;
  }

  double coefficient_, exponent_;
};

}  // namespace bempd::crack

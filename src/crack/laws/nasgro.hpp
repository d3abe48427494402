#pragma once

#include <algorithm>
#include <numbers>

#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// NASGRO equation as in Harter, AFGROW Users Guide and Technical Manual, AFRL-VA-WP-TR-1999-3016: growth per cycle
// da/dN = C [(1 - f) / (1 - R) dK]^n (1 - dK_th / dK)^p / (1 - K_max / K_c)^q. dK = K_max - K_min is the range, dK_th
// its threshold, R = K_min / K_max the load ratio, K_c the toughness; C, n, p and q are material constants. The crack
// opens at the share f of K_max, which depends on the constraint factor alpha (1 in plane stress to 3 in plane strain)
// and on `stress`, the largest stress over the flow stress (Newman, Int. J. Fract. 24, 1984).
class Nasgro final : public RateLaw {
 public:
  struct Closure {
    double alpha = 1, stress = 0;

    double opening(double ratio) const {
      const double a0 = (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) *
                        std::pow(std::cos(0.5 * std::numbers::pi * stress), 1 / alpha);
      const double a1 = (0.415 - 0.071 * alpha) * stress;
      const double a3 = 2 * a0 + a1 - 1, a2 = 1 - a0 - a1 - a3;
      if (ratio < 0) return a0 + a1 * std::max(ratio, -2.0);
      return std::max(ratio, a0 + ratio * (a1 + ratio * (a2 + ratio * a3)));
    }
  };

  Nasgro(double coefficient, double exponent, double p, double q, Closure closure, double threshold)
      : RateLaw(threshold), coefficient_(coefficient), exponent_(exponent), p_(p), q_(q), closure_(closure) {}

 private:
  double growth(const TipCycle& cycle) const override {
    const double ratio = cycle.ratio();
    const double effective = (1 - closure_.opening(ratio)) / (1 - ratio) * cycle.range();
    const double near_threshold = p_ == 0 ? 1 : std::pow(1 - threshold() / cycle.range(), p_);
    const double near_fracture = q_ == 0 ? 1 : std::pow(1 - cycle.highest / cycle.critical, q_);
    return coefficient_ * std::pow(effective, exponent_) * near_threshold / near_fracture;
  }

  double coefficient_, exponent_, p_, q_;
  Closure closure_;
};

}  // namespace bempd::crack

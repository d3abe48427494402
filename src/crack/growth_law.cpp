#include "crack/growth_law.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::crack {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Least slope of the equivalent factor over the load factor at which loads count as opening the tip, as a share of the
// norm of the proportional (K_I, K_II). With a smaller slope the loads press the tip shut, and it does not grow. By the
// hoop stress criterion the slope of a tip that is pressed shut is of third order in K_II / K_I; the slope has the
// given value at K_II / K_I = 6e-4, which is about the error of the stress intensity factors.
constexpr double share_of_rounding = 1e-9;

// Load factor at which the range of load factors without growth ends in `direction` (1 or -1); infinite if the range
// has no end. The end is found by bisection from `inside`, a load factor in the range. At large load factors the
// equivalent factor exceeds the load factor times its slope minus twice the constant part, which bounds the search.
double end_of_range(const AffineFactors& factors, const GrowthLaw& law, double inside, double direction) {
  const double slope = law.kink(direction * factors.proportional).equivalent_factor;
  if (!(slope > share_of_rounding * factors.proportional.stableNorm())) return infinity * direction;
  const double smallest_share = law.directions ? law.directions->smallest_share() : 1;
  const double constant = factors.constant.stableNorm() / std::sqrt(std::min(1.0, smallest_share));
  double low = inside, high = direction * 2 * (law.toughness + 2 * constant) / slope;
  if (law.asking.function) {  // nothing bounds the values of the function
    constexpr int most_doublings = 60;
    for (int k = 0; k < most_doublings && law.ratio(factors, high) < 1; ++k) low = high, high *= 2;
    if (law.ratio(factors, high) < 1) return infinity * direction;
  }
  if (!std::isfinite(high)) return infinity * direction;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (law.ratio(factors, middle) < 1 ? low : high) = middle;
  }
  return high;
}

// Load factor at which the ratio of a tip's equivalent factor to its toughness is least, by golden section search
// between bounds of plus and minus 4 (toughness + norm of the constant factors) / norm of the proportional factors. The
// ratio by hoop stress is used, because it is convex in the load factor everywhere; the ratio by energy release rate is
// not convex where kinks close.
double least_loaded(const AffineFactors& factors, GrowthLaw law) {
  const double size = factors.proportional.stableNorm();
  double high = 4 * (law.toughness + factors.constant.stableNorm()) / size, low = -high;
  law.criterion = KinkCriterion::hoop_stress;
  const auto ratio = [&](double at) { return law.ratio(factors, at); };
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 100; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const bool left = ratio(a) < ratio(b);
    (left ? high : low) = left ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

GrowthLaw GrowthLaw::with_host_toughness(const Point& factors, double t_stress) const {
  if (!asking.function) return *this;
  GrowthLaw law = *this;
  law.asking.function = nullptr;
  if (factors.isZero(0)) return law;
  TipCycle held;
  held.tip = asking.id, held.place = asking.place, held.length = asking.grown, held.t_stress = t_stress;
  held.high = held.low = factors;
  held.highest = held.lowest = kink(factors).equivalent_factor;
  law.toughness = toughness_of(asking.function->energy(held), plane_modulus);
  return law;
}

GrowthRange GrowthLaw::range(const AffineFactors& factors) const {
  if (!(toughness > 0) || std::isinf(toughness)) return {};
  const auto stays = [&](double load_factor) { return ratio(factors, load_factor) < 1; };
  double inside = 0;
  if (!stays(inside)) {
    if (factors.proportional.isZero(0)) return {infinity, -infinity};
    inside = least_loaded(factors, *this);
    if (!stays(inside)) return {infinity, -infinity};
  }
  return {end_of_range(factors, *this, inside, -1), end_of_range(factors, *this, inside, 1)};
}

double GrowthLaw::first_load_factor(const AffineFactors& factors) const {
  if (!directions && !asking.function)
    return growth_load_factor(factors.constant, factors.proportional, toughness, criterion);
  if (!(toughness > 0)) return infinity;
  return ratio(factors, 0) >= 1 ? 0 : range(factors).highest;
}

}  // namespace bempd::crack

#include "crack/growth_law.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::crack {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Smallest slope of the equivalent factor over the size of K that counts: below it the loads press the tip shut, and
// the tip does not grow. By the hoop stress the slope goes with the third power of K_II / K_I and has this value where
// that ratio is 6e-4, which is about the error of the factors.
constexpr double share_of_rounding = 1e-9;

// Load factor at which the range without growth ends in `direction` (1 or -1), by bisection from `inside`, a load
// factor in the range; infinite if there is no end. At large load factors the equivalent factor exceeds the load factor
// times its slope less twice the constant part, which bounds the search.
double end_of_range(const AffineFactors& factors, double toughness, KinkCriterion criterion, double inside,
                    double direction) {
  const double slope = kink_of(direction * factors.proportional, criterion).equivalent_factor;
  if (!(slope > share_of_rounding * factors.proportional.stableNorm())) return infinity * direction;
  double low = inside, high = direction * 2 * (toughness + 2 * factors.constant.stableNorm()) / slope;
  if (!std::isfinite(high)) return infinity * direction;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (growth_ratio(factors, middle, toughness, criterion) < 1 ? low : high) = middle;
  }
  return high;
}

// Load factor at which the growth ratio of a tip is least, by golden section search; the bounds are a few times the
// constant part. The hoop stress criterion is used because its ratio is convex in the load factor everywhere: that of
// the energy release rate is not where kinks close.
double least_loaded(const AffineFactors& factors, double toughness) {
  const double size = factors.proportional.stableNorm();
  double high = 4 * (toughness + factors.constant.stableNorm()) / size, low = -high;
  const auto ratio = [&](double at) { return growth_ratio(factors, at, toughness, KinkCriterion::hoop_stress); };
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 100; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const bool left = ratio(a) < ratio(b);
    (left ? high : low) = left ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

double growth_ratio(const AffineFactors& factors, double load_factor, double toughness, KinkCriterion criterion) {
  return kink_of(factors.at(load_factor), criterion).equivalent_factor / toughness;
}

GrowthRange growth_range(const AffineFactors& factors, double toughness, KinkCriterion criterion) {
  if (!(toughness > 0) || std::isinf(toughness)) return {};
  const auto stays = [&](double load_factor) { return growth_ratio(factors, load_factor, toughness, criterion) < 1; };
  double inside = 0;
  if (!stays(inside)) {
    if (factors.proportional.isZero(0)) return {infinity, -infinity};
    inside = least_loaded(factors, toughness);
    if (!stays(inside)) return {infinity, -infinity};
  }
  return {end_of_range(factors, toughness, criterion, inside, -1),
          end_of_range(factors, toughness, criterion, inside, 1)};
}

}  // namespace bempd::crack

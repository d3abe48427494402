#include "elasticity/kinked_tip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "number_range.hpp"

namespace bempd {

namespace {

constexpr double no_growth = std::numeric_limits<double>::infinity();

constexpr double pi = std::numbers::pi;

// Largest kink angle that is tried [rad], enough for every mixture of modes that opens the tip: in pure shear the
// energy release rate is largest at 75.6 degrees.
constexpr double widest_kink = 1.9;

double polynomial(const std::array<double, 11>& coefficients, double x) {
  double sum = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * x + *c;
  return sum;
}

// Energy release rate times E' of an infinitesimal kink, with a negative sign if the kink would close.
double opening_rate(const Point& factors, double angle) {
  const Point kinked = kinked_factors(factors, angle);
  return kinked.x() > 0 ? kinked.squaredNorm() : -kinked.squaredNorm();
}

Kink largest_hoop_stress(const Point& factors) {
  const double one = factors.x(), two = factors.y();
  double angle = 0;
  // A closed tip with almost no shear has its largest hoop stress straight backwards.
  if (one < 0 && std::abs(two) < -1e-290 * one) {
    if (two != 0) angle = two > 0 ? -pi : pi;
  } else if (two != 0)
    angle = 2 * std::atan((one - std::sqrt(one * one + 8 * two * two)) / (4 * two));
  return {angle, hoop_factor(factors, angle)};
}

Kink largest_energy_release_rate(const Point& factors) {
  if (factors.y() == 0) return {0, factors.x()};
  // The kink turns to the side on which the shear opens the kink. Its angle is found on a grid, then by golden section
  // search.
  const double side = factors.y() > 0 ? -1 : 1;
  constexpr int grid = 48;
  int best = 0;
  for (int i = 1; i <= grid; ++i)
    if (opening_rate(factors, side * widest_kink * i / grid) > opening_rate(factors, side * widest_kink * best / grid))
      best = i;
  double low = widest_kink * std::max(best - 1, 0) / grid, high = widest_kink * std::min(best + 1, grid) / grid;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (opening_rate(factors, side * a) < opening_rate(factors, side * b) ? low : high) =
        opening_rate(factors, side * a) < opening_rate(factors, side * b) ? a : b;
  }
  double angle = side * 0.5 * (low + high), rate = opening_rate(factors, angle);
  // The best kink of a closed tip is the smallest one that opens. Rounding may put the angle just below the smallest
  // opening angle, so larger angles are tried.
  for (const double opens : {side * high, side * widest_kink * best / grid})
    if (rate <= 0) angle = opens, rate = opening_rate(factors, angle);
  return {angle, rate > 0 ? std::sqrt(rate) : -std::sqrt(-rate)};
}

}  // namespace

double hoop_factor(const Point& factors, double angle) {
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  return c * c * (factors.x() * c - 3 * factors.y() * s);
}

Point kinked_factors(const Point& factors, double angle) {
  const double m = angle / pi, m2 = m * m, p2 = pi * pi, p4 = p2 * p2, p6 = p4 * p2;
  const double f11 = polynomial({1, -3 * p2 / 8, p2 - 5 * p4 / 128, p2 / 9 - 11 * p4 / 72 + 119 * p6 / 15360, 5.07790,
                                 -2.88312, -0.0925, 2.996, -4.059, 1.63, 4.1},
                                m2);
  const double f12 =
      m * polynomial({-3 * pi / 2, 10 * pi / 3 + p2 * pi / 16, -2 * pi - 133 * p2 * pi / 180 + 59 * p4 * pi / 1280,
                      12.313906, -7.32433, 1.5793, 4.0216, -6.915, 4.21, 4.56, 0},
                     m2);
  const double f21 =
      m * polynomial({pi / 2, -4 * pi / 3 - p2 * pi / 48, -2 * pi / 3 + 13 * p2 * pi / 30 - 59 * p4 * pi / 3840,
                      -6.176023, 4.44112, -1.5340, -2.0700, 4.684, -3.95, -1.32, 0},
                     m2);
  const double f22 = polynomial({1, -4 - 3 * p2 / 8, 8.0 / 3 + 29 * p2 / 18 - 5 * p4 / 128,
                                 -32.0 / 15 - 4 * p2 / 9 - 1159 * p4 / 7200 + 119 * p6 / 15360, 10.58254, -4.78511,
                                 -1.8804, 7.280, -7.591, 0.25, 12.5},
                                m2);
  return {f11 * factors.x() + f12 * factors.y(), f21 * factors.x() + f22 * factors.y()};
}

double factor_of_kink(const Point& factors, double angle, KinkCriterion criterion) {
  if (criterion == KinkCriterion::hoop_stress) return hoop_factor(factors, angle);
  const double rate = opening_rate(factors, angle);
  return rate > 0 ? std::sqrt(rate) : -std::sqrt(-rate);
}

Point kink_growth(double angle) {
  const double m = angle / pi, m2 = m * m, root = std::sqrt(2 * pi);
  const double g1 = m2 * polynomial({2 * pi * root, -47.933390, 63.665987, -50.70880, 26.66807, -6.0205, -7.3148,
                                     10.947, -2.85, -13.7, 0},
                                    m2);
  const double g2 =
      m *
      polynomial({-2 * root, 12 * root, -59.565733, 61.174444, -39.90249, 15.6222, 3.0343, -12.781, 9.69, 6.62, 0}, m2);
  return {g1, g2};
}

Kink kink_of(const Point& factors, KinkCriterion criterion) {
  if (const int far = far_exponent(factors.lpNorm<Eigen::Infinity>()); far != 0) {
    const Kink kink = kink_of(factors * std::ldexp(1, -far), criterion);
    return {kink.angle, std::ldexp(kink.equivalent_factor, far)};
  }
  return criterion == KinkCriterion::hoop_stress ? largest_hoop_stress(factors) : largest_energy_release_rate(factors);
}

double growth_load_factor(const Point& constant, const Point& proportional, double toughness, KinkCriterion criterion) {
  if (!(toughness > 0)) return no_growth;
  const auto excess = [&](double factor) {
    return kink_of(constant + factor * proportional, criterion).equivalent_factor - toughness;
  };
  if (excess(0) >= 0) return 0;
  const double slope = kink_of(proportional, criterion).equivalent_factor;
  if (!(slope > 0)) return no_growth;
  // The upper bound is a load factor at which growth is certain: both criteria are convex, so that the equivalent
  // factor is at least the load factor times `slope`, less the most that the constant part can subtract.
  double low = 0, high = 2 * (toughness + 2 * constant.stableNorm()) / slope;
  for (int i = 0; i < 100; ++i) (excess(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  return high;
}

}  // namespace bempd

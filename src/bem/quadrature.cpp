#include "bem/quadrature.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace bempd::bem {

namespace {

// Legendre polynomials P_0 .. P_n at x, by the three-term recurrence.
std::vector<long double> legendre(int n, long double x) {
  std::vector<long double> p(n + 1, 1.0L);
  if (n > 0) p[1] = x;
  for (int k = 2; k <= n; ++k) p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) / k;
  return p;
}

long double legendre_root(int n, int i) {
  long double x = -std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L));
  for (int iteration = 0; iteration < 20; ++iteration) {
    const auto p = legendre(n, x);
    const long double step = p[n] * (x * x - 1) / (n * (x * p[n] - p[n - 1]));
    x -= step;
    if (std::abs(step) < 1e-18L) break;
  }
  return x;
}

GaussRule make_rule(int n) {
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    const long double x = legendre_root(n, i);
    const auto p = legendre(n, x);
    const long double derivative = n * (x * p[n] - p[n - 1]) / (x * x - 1);
    const long double weight = 1 / ((1 - x * x) * derivative * derivative);
    // Log weights follow from the expansion of f in Legendre polynomials and the integrals of P_k(2s - 1) ln(s) over
    // [0, 1].
    long double log_factor = -1;
    for (int k = 1; k < n; ++k) log_factor += (2 * k + 1) * p[k] * (k % 2 ? 1.0L : -1.0L) / (k * (k + 1.0L));
    rule.points.push_back(static_cast<double>((1 + x) / 2));
    rule.weights.push_back(static_cast<double>(weight));
    rule.log_weights.push_back(static_cast<double>(weight * log_factor));
  }
  return rule;
}

std::vector<GaussRule> make_rules() {
  std::vector<GaussRule> rules(1);
  for (int n = 1; n <= max_gauss_points; ++n) rules.push_back(make_rule(n));
  return rules;
}

}  // namespace

const GaussRule& gauss_rule(int point_count) {
  static const std::vector<GaussRule> rules = make_rules();
  assert(point_count >= 1 && point_count <= max_gauss_points);
  return rules[point_count];
}

double ellipse_size(double sum_of_distances) {
  const double half = sum_of_distances / 2;
  return half > 1 ? half + std::sqrt(half * half - 1) : 1;
}

int gauss_points_needed(double ellipse, double tolerance) {
  constexpr double never = 1000;
  const double rate = 2 * std::log(ellipse);
  const double points = rate > 0 ? -std::log(tolerance) / rate : never;
  // The additional point accounts for the polynomial factor of the integrand.
  return static_cast<int>(std::ceil(std::min(points, never))) + 1;
}

int regular_rule(int points_needed) {
  int index = 0;
  while (index < static_cast<int>(regular_point_counts.size()) && regular_point_counts[index] < points_needed) ++index;
  return index;
}

RegularRules::RegularRules(double tolerance) {
  for (std::size_t rule = 0; rule < least_sum_.size(); ++rule) {
    // The least sum of distances for a rule with n points is rho + 1 / rho, where rho is the size of the ellipse with
    // rho^(-2 (n - 1)) = tolerance.
    const double ellipse = std::pow(tolerance, -0.5 / (regular_point_counts[rule] - 1));
    least_sum_[rule] = ellipse + 1 / ellipse;
  }
}

}  // namespace bempd::bem

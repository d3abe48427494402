#include "elasticity/griffith.hpp"

#include <cmath>
#include <limits>

namespace bempd {

namespace {
constexpr double never = std::numeric_limits<double>::infinity();
}

double plane_modulus(const PlaneElasticity& elasticity) {
  return 2 * elasticity.shear_modulus() / (1 - elasticity.effective_poisson_ratio());
}

Kink kink_of(const Point& factors) {
  const double one = factors.x(), two = factors.y();
  double angle = 0;
  if (two != 0) angle = 2 * std::atan((one - std::sqrt(one * one + 8 * two * two)) / (4 * two));
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  return {angle, c * c * (one * c - 3 * two * s)};
}

double critical_load_factor(const Point& constant, const Point& proportional, double toughness) {
  const double square = toughness * toughness;
  const double a = proportional.squaredNorm(), b = constant.dot(proportional), c = constant.squaredNorm() - square;
  const double root = b * b - a * c;
  if (!(square > 0) || c >= 0) return square > 0 ? 0.0 : never;
  // Between the two roots, which have different signs, the crack stands still.
  return a > 0 ? (std::sqrt(root) - b) / a : never;
}

// As the largest hoop stress the mode I factor is a convex function of the load factor.
double growth_load_factor(const Point& constant, const Point& proportional, double toughness) {
  if (!(toughness > 0)) return never;
  const auto excess = [&](double factor) {
    return kink_of(constant + factor * proportional).equivalent_factor - toughness;
  };
  if (excess(0) >= 0) return 0;
  const double slope = kink_of(proportional).equivalent_factor;
  if (!(slope > 0)) return never;
  // It lies above the factor times `slope` less what the constant part can take away.
  double low = 0, high = 2 * (toughness + 2 * constant.norm()) / slope;
  for (int i = 0; i < 100; ++i) (excess(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  return high;
}

}  // namespace bempd

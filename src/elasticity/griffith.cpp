#include "elasticity/griffith.hpp"

#include <cmath>
#include <limits>

namespace bempd {

namespace {
constexpr double never = std::numeric_limits<double>::max();
}

double plane_modulus(const PlaneElasticity& elasticity) {
  return 2 * elasticity.shear_modulus() / (1 - elasticity.effective_poisson_ratio());
}

double critical_load_factor(const Point& constant, const Point& proportional, double toughness) {
  const double square = toughness * toughness;
  const double a = proportional.squaredNorm(), b = constant.dot(proportional), c = constant.squaredNorm() - square;
  const double root = b * b - a * c;
  if (!(square > 0) || c >= 0) return square > 0 ? 0.0 : never;
  // Between the two roots, which have different signs, the crack stands still.
  return a > 0 ? (std::sqrt(root) - b) / a : never;
}

}  // namespace bempd

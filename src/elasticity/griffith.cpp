#include "elasticity/griffith.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "number_range.hpp"

namespace bempd {

namespace {
constexpr double never = std::numeric_limits<double>::max();
}

double plane_modulus(const PlaneElasticity& elasticity) {
  return 2 * elasticity.shear_modulus() / (1 - elasticity.effective_poisson_ratio());
}

double straight_load_factor(const Point& constant, const Point& proportional, double toughness) {
  if (!(toughness > 0)) return never;
  const int held = far_exponent(std::max(toughness, constant.lpNorm<Eigen::Infinity>()));
  const int growing = far_exponent(proportional.lpNorm<Eigen::Infinity>());
  if (held != 0 || growing != 0) {
    const double unit = std::ldexp(1, -held);
    const double near = straight_load_factor(constant * unit, proportional * std::ldexp(1, -growing), toughness * unit);
    return near < never ? in_range(std::ldexp(near, held - growing)) : never;
  }
  const double square = toughness * toughness;
  const double a = proportional.squaredNorm(), b = constant.dot(proportional), c = constant.squaredNorm() - square;
  const double root = b * b - a * c;
  if (c >= 0) return 0;
  // The crack does not grow between the two roots, which have different signs; the positive root is the result.
  return a > 0 ? in_range((std::sqrt(root) - b) / a) : never;
}

}  // namespace bempd

#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd::bem_test {

// Cantilever 0 <= x <= L, |y| <= H/2 with the parabolic end shear of resultant P (Timoshenko and Goodier, Theory of
// Elasticity, 3rd ed., section 21; the sign of P is that of the force on the end x = L).
//   sigma_xx = -P (L - x) y / I,  sigma_yy = 0,  sigma_xy = P (H^2/4 - y^2) / (2 I),  I = h H^3 / 12.
struct Cantilever {
  PlaneElasticity elasticity;
  double length = 1, height = 0.2, load = 1;

  double inertia() const { return elasticity.thickness * height * height * height / 12; }
  // Young's modulus and Poisson's ratio to be used in plane-stress formulas.
  double poisson() const {
    const double nu = elasticity.effective_poisson_ratio();
    return nu / (1 - nu);
  }
  double young() const { return 2 * elasticity.shear_modulus() * (1 + poisson()); }

  Point displacement(const Point& p) const {
    const double x = p.x(), y = p.y(), nu = poisson(), factor = load / (6 * young() * inertia());
    return {
        -factor * y * ((6 * length - 3 * x) * x + (2 + nu) * (y * y - height * height / 4)),
        factor * (3 * nu * y * y * (length - x) + (4 + 5 * nu) * height * height * x / 4 + (3 * length - x) * x * x)};
  }
  Eigen::Matrix2d stress(const Point& p) const {
    const double bending = -load * (length - p.x()) * p.y() / inertia();
    const double shear = load * (height * height / 4 - p.y() * p.y()) / (2 * inertia());
    Eigen::Matrix2d s;
    s << bending, shear, shear, 0;
    return s;
  }
};

}  // namespace bempd::bem_test

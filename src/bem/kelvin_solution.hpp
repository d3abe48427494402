#pragma once

#include <cmath>
#include <numbers>

#include "geometry/point.hpp"

namespace bempd::bem {

// Kelvin's solution: a point force in the infinite plane-strain body of unit shear modulus; r is the vector from the
// force to the field point. Rows belong to the direction of the force, columns to the component of the result (Brebbia
// and Dominguez, Boundary Elements, 2nd ed., section 3.4).
struct KelvinSolution {
  double nu;  // effective Poisson's ratio

  Eigen::Matrix2d displacement(const Point& r) const {
    const double r2 = r.squaredNorm();
    const double factor = 1 / (8 * std::numbers::pi * (1 - nu));
    Eigen::Matrix2d u = r * r.transpose() * (factor / r2);
    u.diagonal().array() -= factor * (3 - 4 * nu) * 0.5 * std::log(r2);
    return u;
  }

  // Traction on a surface element with the normal `normal`; if the normal has another length than 1, the traction is
  // scaled by it.
  Eigen::Matrix2d traction(const Point& r, const Point& normal) const {
    const double r2 = r.squaredNorm();
    const double factor = -1 / (4 * std::numbers::pi * (1 - nu));
    const double along = r.dot(normal) / r2, across = cross(normal, r) / r2;
    Eigen::Matrix2d t = r * r.transpose() * (2 * along / r2);
    t.diagonal().array() += (1 - 2 * nu) * along;
    t(0, 1) += (1 - 2 * nu) * across;
    t(1, 0) -= (1 - 2 * nu) * across;
    return factor * t;
  }

  // Stress (xx, yy, xy) at the point x due to the traction t, or the displacement u, of a surface element at x + r with
  // the normal n. Somigliana's identity: stress = integral of (stress_from_traction - stress_from_displacement).
  Eigen::Vector3d stress_from_traction(const Point& r, const Point& t) const {
    const double r2 = r.squaredNorm(), rt = r.dot(t);
    const double shear = 1 - 2 * nu, triple = 2 * rt / r2;
    const Eigen::Vector3d s(shear * (2 * t.x() * r.x() - rt) + triple * r.x() * r.x(),
                            shear * (2 * t.y() * r.y() - rt) + triple * r.y() * r.y(),
                            shear * (t.x() * r.y() + t.y() * r.x()) + triple * r.x() * r.y());
    return s / (4 * std::numbers::pi * (1 - nu) * r2);
  }

  Eigen::Vector3d stress_from_displacement(const Point& r, const Point& n, const Point& u) const {
    const double r2 = r.squaredNorm();
    const Point e = r / std::sqrt(r2);
    const double en = e.dot(n), eu = e.dot(u), nu_dot = n.dot(u), shear = 1 - 2 * nu;
    const auto component = [&](int i, int j) {
      const double delta = i == j ? 1 : 0;
      return 2 * en * (shear * delta * eu + nu * (u[i] * e[j] + u[j] * e[i]) - 4 * e[i] * e[j] * eu) +
             2 * nu * (n[i] * e[j] + n[j] * e[i]) * eu +
             shear * (2 * nu_dot * e[i] * e[j] + n[j] * u[i] + n[i] * u[j]) - (1 - 4 * nu) * nu_dot * delta;
    };
    return Eigen::Vector3d(component(0, 0), component(1, 1), component(0, 1)) / (2 * std::numbers::pi * (1 - nu) * r2);
  }
};

}  // namespace bempd::bem

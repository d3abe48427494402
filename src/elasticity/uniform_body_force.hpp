#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// A state of an infinite plane body under a constant force b per volume: stresses
//   sigma_xx = -b_x x,  sigma_yy = -b_y y,  sigma_xy = 0,
// which satisfy div sigma + b = 0 and, being linear, are compatible, with the quadratic displacements that belong to
// them. Places are relative to a centre near the body, for the sake of digits.
class UniformBodyForce {
 public:
  UniformBodyForce(const PlaneElasticity& elasticity, const Point& body_force, const Point& centre)
      : b_(body_force),
        centre_(centre),
        along_((1 - elasticity.effective_poisson_ratio()) / (2 * elasticity.shear_modulus())),
        across_(-elasticity.effective_poisson_ratio() / (2 * elasticity.shear_modulus())) {}

  Point displacement(const Point& place) const {
    const Point r = place - centre_;
    return {-0.5 * along_ * b_.x() * r.x() * r.x() - across_ * (b_.y() * r.x() * r.y() - 0.5 * b_.x() * r.y() * r.y()),
            -0.5 * along_ * b_.y() * r.y() * r.y() - across_ * (b_.x() * r.x() * r.y() - 0.5 * b_.y() * r.x() * r.x())};
  }

  const Point& centre() const { return centre_; }

  // xx, yy, xy [Pa].
  Eigen::Vector3d stress(const Point& place) const {
    const Point r = place - centre_;
    return {-b_.x() * r.x(), -b_.y() * r.y(), 0};
  }

 private:
  Point b_, centre_;
  double along_, across_;  // strain of a stress in its own direction and across it [1/Pa]
};

}  // namespace bempd

#pragma once

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Body force per volume that is linear in the place x: uniform [N/m^3] plus growth [N/m^4] times x.
struct BodyForce {
  Point uniform = Point::Zero();
  double growth = 0;

  BodyForce() = default;
  BodyForce(const Point& everywhere, double its_growth = 0) : uniform(everywhere), growth(its_growth) {}

  bool is_zero() const { return uniform == Point::Zero() && growth == 0; }
  Point at(const Point& x) const { return growth == 0 ? uniform : Point(uniform + growth * x); }
};

// Particular solution for an infinite plane body under a linear body force b + k r, where r is the vector from a centre
// near the body (for accuracy). The constant part b has the stresses
//   sigma_xx = -b_x x,  sigma_yy = -b_y y,  sigma_xy = 0,
// which satisfy div sigma + b = 0 and are compatible, because they are linear; the displacements are quadratic. The
// part k r has the radial displacement -k r^3 / (8 c11) (Timoshenko and Goodier, Theory of Elasticity, 3rd ed., section
// 30).
class LinearBodyForce {
 public:
  LinearBodyForce(const PlaneElasticity& elasticity, const BodyForce& force, const Point& centre)
      : b_(force.at(centre)),
        growth_(force.growth),
        centre_(centre),
        along_((1 - elasticity.effective_poisson_ratio()) / (2 * elasticity.shear_modulus())),
        across_(-elasticity.effective_poisson_ratio() / (2 * elasticity.shear_modulus())),
        ratio_(elasticity.effective_poisson_ratio() / (1 - elasticity.effective_poisson_ratio())),
        cubic_(-force.growth * (1 - 2 * elasticity.effective_poisson_ratio()) /
               (16 * elasticity.shear_modulus() * (1 - elasticity.effective_poisson_ratio()))) {}

  Point displacement(const Point& place) const {
    return growth_ == 0 ? quadratic(place) : Point(quadratic(place) + cubic(place));
  }
  // Part of the displacement that is quadratic in the distance from the centre; cubic() is the rest.
  Point quadratic(const Point& place) const {
    const Point r = place - centre_;
    return {-0.5 * along_ * b_.x() * r.x() * r.x() - across_ * (b_.y() * r.x() * r.y() - 0.5 * b_.x() * r.y() * r.y()),
            -0.5 * along_ * b_.y() * r.y() * r.y() - across_ * (b_.x() * r.x() * r.y() - 0.5 * b_.y() * r.x() * r.x())};
  }
  Point cubic(const Point& place) const {
    const Point r = place - centre_;
    return cubic_ * r.squaredNorm() * r;
  }

  const Point& centre() const { return centre_; }
  const Point& at_centre() const { return b_; }  // body force at the centre [N/m^3]

  // Stress (xx, yy, xy) [Pa] at a place.
  Eigen::Vector3d stress(const Point& place) const {
    const Point r = place - centre_;
    const Eigen::Vector3d constant(-b_.x() * r.x(), -b_.y() * r.y(), 0);
    if (growth_ == 0) return constant;
    // The cubic part has the stresses -k r^2 / 8 (3 + q) along the radius and -k r^2 / 8 (1 + 3 q) across it, where k
    // is the growth of the body force, r the distance from the centre and q = c12 / c11.
    const double all_sides = -growth_ / 8 * (1 + 3 * ratio_) * r.squaredNorm(), along = -growth_ / 4 * (1 - ratio_);
    return constant +
           Eigen::Vector3d(all_sides + along * r.x() * r.x(), all_sides + along * r.y() * r.y(), along * r.x() * r.y());
  }

 private:
  Point b_;
  double growth_;
  Point centre_;
  double along_, across_;  // strain per stress, in its direction and across it [1/Pa]
  double ratio_;           // c12 / c11
  double cubic_;
};

}  // namespace bempd

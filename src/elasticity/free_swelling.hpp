#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// Swelling: stress-free strain of a material at a place, equal in all directions of the plane, such as thermal strain.
// The first value is the constant part, the second value is the part that is multiplied by the load factor.
using Swelling = std::function<Eigen::Vector2d(const Point&)>;

// Linear swelling e = e0 + g.(x - centre), and the displacement that it causes in a free body. The body has no stress,
// because a linear swelling is compatible:
//   u_x = e0 x + g_x (x^2 - y^2) / 2 + g_y x y,  u_y = e0 y + g_x x y + g_y (y^2 - x^2) / 2.
class FreeSwelling {
 public:
  // Linear swelling with the values of `swelling` at these places; empty if the values are not linear, up to rounding.
  static std::optional<FreeSwelling> through(const std::vector<Point>& places, const Swelling& swelling);

  // Displacement at a place [m]: column 0 is the constant part, column 1 the part that is multiplied by the load
  // factor.
  Eigen::Matrix2d displacement(const Point& place) const;

 private:
  FreeSwelling(const Point& centre, const Eigen::Matrix<double, 3, 2>& coefficients)
      : centre_(centre), coefficients_(coefficients) {}

  Point centre_;
  Eigen::Matrix<double, 3, 2> coefficients_;  // e0, g_x, g_y, for each part
};

}  // namespace bempd

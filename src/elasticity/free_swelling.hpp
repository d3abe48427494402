#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// A strain that a material wants without stress, the same in all directions of the plane, such as that of heat: its
// constant part and the one that is multiplied by the load factor, at a place.
using Swelling = std::function<Eigen::Vector2d(const Point&)>;

// A swelling e = e0 + g.(x - centre) that a body follows freely, since it is linear and so compatible:
//   u_x = e0 x + g_x (x^2 - y^2) / 2 + g_y x y,  u_y = e0 y + g_x x y + g_y (y^2 - x^2) / 2.
class FreeSwelling {
 public:
  // Nothing if the swelling at these places is not linear, up to rounding.
  static std::optional<FreeSwelling> through(const std::vector<Point>& places, const Swelling& swelling);

  // Column 0 the constant part, column 1 the other.
  Eigen::Matrix2d displacement(const Point& place) const;
  Point displacement(const Point& place, double load_factor) const {
    return displacement(place) * Eigen::Vector2d(1, load_factor);
  }

 private:
  FreeSwelling(const Point& centre, const Eigen::Matrix<double, 3, 2>& coefficients)
      : centre_(centre), coefficients_(coefficients) {}

  Point centre_;
  Eigen::Matrix<double, 3, 2> coefficients_;  // e0, g_x, g_y, for each part
};

}  // namespace bempd

#pragma once

#include <cmath>

#include "geometry/point.hpp"

namespace bempd {

// Vector `direction` turned counter-clockwise by an angle [rad].
inline Point turned(const Point& direction, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * direction.x() - s * direction.y(), s * direction.x() + c * direction.y()};
}

// Angle of a direction from the x axis, counter-clockwise [rad].
inline double heading_of(const Point& direction) { return std::atan2(direction.y(), direction.x()); }

inline Point left_of(const Point& direction) { return {-direction.y(), direction.x()}; }

}  // namespace bempd

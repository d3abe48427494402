#pragma once

#include <Eigen/Core>

namespace bempd {

using Point = Eigen::Vector2d;

// z component of the cross product a x b.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace bempd

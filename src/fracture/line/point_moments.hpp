#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/terms.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Contribution of a term with unit tension to the stress (xx, yy, xy along a direction) times area of one of its
// points: half of force times bond vector for a bond; for a wide term the moments of its pulls about the point, in
// equal shares.
Eigen::Vector3d moment_at(const coupling::Terms& terms, const std::vector<Point>& positions, std::size_t term, int node,
                          const Point& direction);

}  // namespace bempd::fracture

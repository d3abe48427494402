#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/terms.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Contribution of a term (bond or cell square) with unit tension to the stress of its point `node` times the volume of
// that point: (xx, yy, xy) in axes along `direction`. A bond contributes half of force times bond vector. A cell square
// (wide term) contributes the moments of its nodal forces about the point, divided by the number of its points.
Eigen::Vector3d moment_at(const coupling::Terms& terms, const std::vector<Point>& positions, std::size_t term, int node,
                          const Point& direction);

}  // namespace bempd::fracture

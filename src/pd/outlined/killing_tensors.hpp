#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// The ten cubic Killing tensor fields at points, four rows each, in the form in which they multiply the third moments
// 111, 112, 122, 222 of bonds; orthonormal. Both ends of a bond have the same product with them, so bonds cannot change
// these sums.
Eigen::MatrixXd killing_tensors(const std::vector<Point>& places);

}  // namespace bempd::pd

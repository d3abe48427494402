#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// The ten cubic Killing tensor fields at points, four rows each, that are what they make of the third moments 111, 112,
// 122, 222 of bonds there; orthonormal. Both ends of a bond see the same, so that bonds move no moments along them.
Eigen::MatrixXd killing_tensors(const std::vector<Point>& places);

}  // namespace bempd::pd

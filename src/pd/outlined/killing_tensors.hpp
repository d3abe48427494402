#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// Ten cubic Killing tensor fields at some places, four rows for each place, orthonormal. The rows are the factors of
// the third moments 111, 112, 122, 222 of bonds. Both ends of a bond have the same product with such a field, so bonds
// cannot change the sum of these products over all points.
Eigen::MatrixXd killing_tensors(const std::vector<Point>& places);

}  // namespace bempd::pd

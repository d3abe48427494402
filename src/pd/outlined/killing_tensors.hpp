#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// Ten cubic Killing tensor fields at some places, as orthonormal columns with four rows for each place. The four rows
// multiply the third moments 111, 112, 122, 222 of bonds. A bond has the same product with such a field at both of its
// ends, so that bonds cannot change the sum of these products over all points.
Eigen::MatrixXd killing_tensors(const std::vector<Point>& places);

}  // namespace bempd::pd

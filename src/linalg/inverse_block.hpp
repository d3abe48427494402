#pragma once

#include <cholmod.h>

#include <Eigen/Core>
#include <vector>

namespace bempd::linalg {

// The block of A^-1 on some places in the order of elimination, from CHOLMOD's factor of A, changed or not. Only the
// columns of the factor on the ways of these places to the root of the elimination tree are read: a small part of all
// where the places lie close together.
Eigen::MatrixXd inverse_block(const cholmod_factor& factor, const std::vector<int>& places);

}  // namespace bempd::linalg

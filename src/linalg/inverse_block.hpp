#pragma once

#include <cholmod.h>

#include <Eigen/Core>
#include <vector>

namespace bempd::linalg {

// Block of A^-1 for some unknowns, from CHOLMOD's factor of A (changed or not). `places` are the places of these
// unknowns in the order of elimination. Only the columns of the factor on the paths from these places to the root of
// the elimination tree are read: few columns if the places lie close together.
template <class Index>
Eigen::MatrixXd inverse_block(const cholmod_factor& factor, const std::vector<int>& places);

}  // namespace bempd::linalg

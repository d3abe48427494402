#pragma once

#include <functional>
#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// The faces of cracks among bonds: between two cells of a lattice for every bond of nearest neighbours that is gone,
// with the displacement of the point on the left of its line less that of the one on the right. One picture for each
// crack that is the nearest, or one of number 0 if there is none.
std::vector<CrackPicture> lattice_crack_pictures(const BondedBody& body, const Eigen::VectorXd& displacement,
                                                 const std::function<int(const Point&)>& nearest_crack);

}  // namespace bempd::regions

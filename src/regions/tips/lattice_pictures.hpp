#pragma once

#include <functional>
#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Pictures of the faces of cracks in lattices: between two cells of a lattice for every broken bond of nearest
// neighbours, with the displacement of the point on the left of its line less that of the one on the right. There is
// one picture for each crack that is nearest to some bond, or one of number 0 if there are no cracks.
std::vector<CrackPicture> lattice_crack_pictures(const BondedBody& body, const Eigen::VectorXd& displacement,
                                                 const std::function<int(const Point&)>& nearest_crack);

}  // namespace bempd::regions

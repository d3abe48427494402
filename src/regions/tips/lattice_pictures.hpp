#pragma once

#include <functional>
#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Pictures of the faces of cracks in lattices: one segment across every broken bond between nearest neighbours. The
// opening of a segment is the displacement of the point on the segment's left less that of the point on its right.
// `nearest_crack` gives the id of the crack that is nearest to a place; 0 if there are no cracks.
std::vector<CrackPicture> lattice_crack_pictures(const BondedBody& body, const Eigen::VectorXd& displacement,
                                                 const std::function<int(const Point&)>& nearest_crack);

}  // namespace bempd::regions

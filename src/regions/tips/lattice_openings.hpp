#pragma once

#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Openings of the crack number `crack` (index) in lattices at fractions of its length: displacement of its left face
// less that of its right face, as tangential and normal component [m]. NaN where one side has too few points.
//
// The displacement of a face is extrapolated to the crack by a quadratic fit to nearby points on that side, without
// points that a crack hides. `paths` are the polylines of all cracks in lattices, `displacement` that of the nodes.
std::vector<Point> lattice_openings(const BondedBody& body, const std::vector<std::vector<Point>>& paths,
                                    std::size_t crack, const std::vector<double>& fractions,
                                    const Eigen::VectorXd& displacement);

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Openings of a crack in lattices at fractions of its length: displacement of the crack's left face less that of its
// right face, as tangential and normal component [m]. NaN where one side of the crack has too few material points.
// `crack` is the index of the crack in `paths`, which has the polylines of all cracks in lattices.
//
// The displacement of a face is extrapolated to the crack by a quadratic fit (linear if there are few points) to nearby
// points on that side, without points that a crack hides. `displacement` has the displacements of all nodes.
std::vector<Point> lattice_openings(const BondedBody& body, const std::vector<std::vector<Point>>& paths,
                                    std::size_t crack, const std::vector<double>& fractions,
                                    const Eigen::VectorXd& displacement);

}  // namespace bempd::regions

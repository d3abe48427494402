#pragma once

#include <vector>

#include "regions/tips/tip_rings.hpp"

namespace bempd::regions {

// Openings of a crack in lattices at fractions of its length: displacement of the face on its left less that of the
// face on its right, along it and normal to it [m]; NaN where one side has too few points.
//
// The displacement of a face is the value, on the path, of a quadratic that is fitted to nearby points on its side
// which no crack hides. `paths`: those of all cracks in lattices; the crack is one of them.
std::vector<Point> lattice_openings(const BondedBody& body, const std::vector<std::vector<Point>>& paths,
                                    std::size_t crack, const std::vector<double>& fractions,
                                    const Eigen::VectorXd& displacement);

}  // namespace bempd::regions

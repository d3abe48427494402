#pragma once

#include "pd/outlined/outlined_bonds.hpp"

namespace bempd::pd {

// Changes the stiffnesses of free bonds by the least sum of squares, relative to the kernel's, so that their points
// have no missing moments and none is below `lower` of the kernel's. `surface`: outward vectors of points. `evenness`,
// empty or of every point: weight of the squares of its missing even moments beside those of the changes. Returns false
// if that was not found. With the `places` of all points their Killing tensor fields are kept out of the multipliers,
// which are found to more digits before they decide which bonds are held: long layers need this, and it changes digits.
bool balance_layer(const std::vector<Point>& surface, const std::vector<double>& evenness, double lower, int threads,
                   OutlinedBonds& bonds, const std::vector<Point>& places = {});

}  // namespace bempd::pd

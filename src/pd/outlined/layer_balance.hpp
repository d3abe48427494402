#pragma once

#include "pd/outlined/outlined_bonds.hpp"

namespace bempd::pd {

// Changes the stiffnesses of free bonds by the least sum of squares, relative to the kernel's, so that their points
// lack nothing, with none below `lower` of the kernel's. `surface`: outward vectors of points. False if that was not
// found.
bool balance_layer(const std::vector<Point>& surface, double lower, int threads, OutlinedBonds& bonds);

}  // namespace bempd::pd

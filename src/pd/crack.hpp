#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Bonds that meet a closed polyline in lattice coordinates, ascending. Touching it, also at an end, within 1e-9
// spacings counts as meeting.
std::vector<int> bonds_cut_by(const CellLattice& lattice, const std::vector<Bond>& bonds,
                              const std::vector<Point>& polyline);

// Material points on a polyline, within 1e-9 spacings.
std::vector<int> points_on(const CellLattice& lattice, const std::vector<Point>& polyline);

}  // namespace bempd::pd

#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Cracks are polylines in lattice coordinates. A bond is cut if it meets the closed polyline: touching, with the bond's
// end or the crack's tip, counts. Distances up to 1e-9 count as touching.
std::vector<int> bonds_cut_by(const CellLattice& lattice, const std::vector<Bond>& bonds,
                              const std::vector<Point>& polyline);

// Material points on the polyline. They would hold on to neither face of the crack.
std::vector<int> points_on(const CellLattice& lattice, const std::vector<Point>& polyline);

}  // namespace bempd::pd

#pragma once

#include <array>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::paper {

// Makes the bonds of the discretized peridynamic equation as published (Yang and Liu 2021, Eqs. 13, 19 and 20), without
// any correction at surfaces. Every pair of points closer than the horizon has a bond, with the stiffness c(r) / r
// times the volume factor times both volumes, where r is the bond's length and c the micromodulus. Linear fields are
// not exact, neither in the bulk nor at faces, so residuals and weights in Network keep their defaults.
// `bulk_stiffness` of an offset is that of two unit volumes.
//
// Points may lie anywhere. Lengths are in units of the spacing, so the horizon is `horizon_ratio`. A point's volume is
// 1 for a full cell (spacing^2 times thickness). `faces` are straight pieces of the body's boundary: bonds that cross
// faces are left out, bonds that touch faces or run along them stay. Poisson's ratio must be that of a bond-based
// solid.
pd::Network build_uncorrected_network(const std::vector<Point>& points, const std::vector<double>& volumes,
                                      const std::vector<std::array<Point, 2>>& faces, int horizon_ratio,
                                      const PlaneElasticity& elasticity);

}  // namespace bempd::paper

#pragma once

#include "body.hpp"

namespace directions {

// Points of the layout that lie in the box |x - centre| < half.
std::vector<Point> make_points(const Layout& layout, const Point& centre, const Point& half);

// Bonds between points closer than the horizon, with stiffnesses of the layout's kernel: on a lattice with exact
// elastic constants, otherwise balanced so that every inner point carries its share.
std::vector<Bond> make_bonds(const Layout& layout, const std::vector<Point>& points);

// Stretch at which a straight cut through the bulk costs one, on average over the direction of the cut.
double mean_critical_stretch(const std::vector<Bond>& bonds, double area);

}  // namespace directions

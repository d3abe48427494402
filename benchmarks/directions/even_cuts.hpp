#pragma once

#include "body.hpp"

namespace directions {

// What a straight cut through a lattice costs over the directions of the cut: least and largest over the mean.
struct Cuts {
  double least = 1, largest = 1;
};

// With critical stretches of bonds that are these factors times the body's.
Cuts cost_of_cuts(const Body& lattice, const std::vector<double>& factors);

// Factors to the critical stretch by a bond's direction with which straight cuts cost the same along all directions of
// bonds, G0 on average. Between two neighbouring directions with the angle g between them the cost is an arc of a
// cosine, by 1 / cos(g/2) larger in its middle: less is impossible in any gap, so these factors have the least ripple.
std::vector<double> even_stretches(const Body& lattice);

}  // namespace directions

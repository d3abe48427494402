#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// Boundary element of a subdomain, directed so that the subdomain lies on its left.
struct SubdomainSide {
  std::array<int, 3> nodes;  // start, middle, end
  double sweep = 0;          // angle by which the tangent turns along the side
  int panel = 0;             // panel of the body's mesh, or a number of its own for each cut
  int element = -1;          // number in the body's mesh; -1 on a cut
};

using SubdomainLoop = std::vector<SubdomainSide>;
// Loops of a subdomain: the outer loop first, counter-clockwise, then holes, clockwise.
using SubdomainLoops = std::vector<SubdomainLoop>;

// Ends of the elements on a straight cut through the material, or on a crack, in order.
using Stations = std::vector<Point>;

// Whether a place lies inside a loop whose sides are taken as straight.
bool encloses(const SubdomainLoop& loop, const Point& place, const std::vector<Point>& positions);

// Splits a subdomain along cuts. Each cut is a row of sides from one node of a loop or of another cut to another such
// node. `positions` has the places of all nodes. The result is empty if the cuts do not divide the subdomain into
// closed parts.
std::vector<SubdomainLoops> split(const SubdomainLoops& loops, const std::vector<SubdomainLoop>& cuts,
                                  const std::vector<Point>& positions);

}  // namespace bempd

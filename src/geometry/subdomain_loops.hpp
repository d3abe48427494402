#pragma once

#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace bempd {

// Boundary element of a subdomain, directed so that the subdomain lies on its left.
struct SubdomainSide {
  std::array<int, 3> nodes;  // start, middle, end
  double sweep = 0;          // angle by which the tangent turns along it
  int panel = 0;             // panel of the body's mesh, or a number of its own for each cut
  int element = -1;          // number in the body's mesh; -1 on a cut
};

using SubdomainLoop = std::vector<SubdomainSide>;
// Loops of a subdomain: the outer one first, counter-clockwise, then holes, clockwise.
using SubdomainLoops = std::vector<SubdomainLoop>;

// Straight cut through the material, or crack: the ends of the elements on it, in order.
using Stations = std::vector<Point>;

// Whether a place lies inside a loop whose sides are taken as straight.
bool encloses(const SubdomainLoop& loop, const Point& place, const std::vector<Point>& positions);

// Splits a subdomain along cuts. Each cut is a row of sides from one node to another, of a loop or of another cut.
// `positions` has the places of all nodes. The result is empty if the cuts do not divide it into closed parts.
std::vector<SubdomainLoops> split(const SubdomainLoops& loops, const std::vector<SubdomainLoop>& cuts,
                                  const std::vector<Point>& positions);

}  // namespace bempd

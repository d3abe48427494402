#pragma once

#include "regions/region_borders.hpp"

namespace bempd::regions {

// Row of material points of a region on a straight interface, in order, with the distance `point_distance` between
// neighbours [m].
struct PointRow {
  int region;
  std::vector<Point> places;
  std::vector<int> nodes;  // numbers of the points' nodes in the scene
  double point_distance;
};

// Ties a row of points to the boundary elements of the region `leader` (an id). Throws Error (argument) if the elements
// cannot be joined to the points.
void tie(const PointRow& row, const LeadingElements& leading, int leader, coupling::NodeTies& ties);

}  // namespace bempd::regions

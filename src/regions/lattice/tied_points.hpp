#pragma once

#include "regions/region_borders.hpp"

namespace bempd::regions {

// Row of material points of a region on a straight interface, in order and `point_distance` from each other.
struct PointRow {
  int region;
  std::vector<Point> places;
  std::vector<int> nodes;  // of the scene
  double point_distance;
};

// Ties a row to the elements of the region `leader`. Throws Error (argument) if these cannot be joined to its points.
void tie(const PointRow& row, const LeadingElements& leading, int leader, coupling::NodeTies& ties);

}  // namespace bempd::regions

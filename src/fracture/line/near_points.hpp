#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

// Search for points near a place, by square buckets.
class NearPoints {
 public:
  explicit NearPoints(const std::vector<Point>& points);

  // Numbers of points, ascending: all that are at most this far away, and others nearby.
  std::vector<int> about(const Point& place, double reach) const;

 private:
  // Row or column of buckets in which a coordinate lies, counted from the lowest one of all points.
  int number_of(double distance, int count) const;

  Point lowest_{0, 0};
  double side_ = 1;
  int columns_ = 1, rows_ = 1;
  linalg::Adjacency points_in_;
};

}  // namespace bempd::fracture

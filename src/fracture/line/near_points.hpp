#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

// Search for points near a place, by square buckets (cells of a grid).
class NearPoints {
 public:
  explicit NearPoints(const std::vector<Point>& points);

  // Numbers of points, ascending: all points within `reach` of a place, and some others nearby.
  std::vector<int> about(const Point& place, double reach) const;

 private:
  // Number of the row or column of buckets at a distance from the lowest coordinate of all points; `count` is the
  // number of rows or columns.
  int bucket_index(double distance, int count) const;

  Point lowest_{0, 0};
  double side_ = 1;
  int columns_ = 1, rows_ = 1;
  linalg::Adjacency points_in_;
};

}  // namespace bempd::fracture

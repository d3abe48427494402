#pragma once

#include <cstddef>
#include <vector>

#include "geometry/blocks.hpp"
#include "geometry/segment.hpp"

namespace bempd {

// Polyline with the distance along it (`way`) of each of its points.
class MeasuredPath {
 public:
  explicit MeasuredPath(std::vector<Point> points);

  double length() const { return ways_.back(); }
  std::size_t pieces() const { return points_.size() - 1; }
  Segment piece(std::size_t i) const { return {points_[i], points_[i + 1]}; }
  double way(std::size_t i) const { return ways_[i]; }
  Point at(double way) const;

  struct Nearest {
    double way, distance;
  };
  Nearest nearest(const Point& place) const;

 private:
  std::vector<Point> points_;
  std::vector<double> ways_;
};

// Crossing of a path with a line of the grid of blocks.
struct GridCrossing {
  double way;        // distance along the path
  std::size_t axis;  // axis of the line's normal
  int line;          // number of the line
  int row;           // row (along the line) of the blocks on either side
};

// Crossings of a path with lines of a grid, sorted by their distance along the path.
std::vector<GridCrossing> crossings_of(const MeasuredPath& path, const BlockGrid& grid);

}  // namespace bempd

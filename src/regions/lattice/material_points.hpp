#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace bempd::regions {

// Material points of a peridynamic region, in grid coordinates (in spacings from the origin of the region's grid).
class MaterialPoints {
 public:
  MaterialPoints(double spacing, int horizon_ratio) : spacing_(spacing), horizon_ratio_(horizon_ratio) {}

  double spacing() const { return spacing_; }           // [m]
  int horizon_ratio() const { return horizon_ratio_; }  // horizon over spacing
  const Point& origin() const { return origin_; }
  int point_count() const { return static_cast<int>(points_.size()); }

  Point to_grid(const Point& p) const { return (p - origin_) / spacing_; }
  Point from_grid(const Point& p) const { return origin_ + spacing_ * p; }
  // Place of one point [m].
  Point position(int point) const { return from_grid(points_[static_cast<std::size_t>(point)]); }
  // Places of all points [m].
  std::vector<Point> positions() const {
    std::vector<Point> all;
    all.reserve(points_.size());
    for (int i = 0; i < point_count(); ++i) all.push_back(position(i));
    return all;
  }

 protected:
  std::vector<Point> points_;
  Point origin_ = Point::Zero();  // place of (0, 0) [m]

 private:
  double spacing_;
  int horizon_ratio_;
};

}  // namespace bempd::regions

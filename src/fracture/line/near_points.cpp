#include "fracture/line/near_points.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::fracture {

namespace {

constexpr double points_in_a_bucket = 16;

// Rounding of distances, in side lengths of buckets.
constexpr double rounding_of_distances = 1e-6;

}  // namespace

NearPoints::NearPoints(const std::vector<Point>& points) {
  Point highest(0, 0);
  if (!points.empty()) lowest_ = highest = points.front();
  for (const Point& p : points) lowest_ = lowest_.cwiseMin(p), highest = highest.cwiseMax(p);
  const Point extent = highest - lowest_;
  const double share = std::min(1.0, points_in_a_bucket / std::max(1.0, static_cast<double>(points.size())));
  side_ = std::max(std::sqrt(extent.x()) * std::sqrt(extent.y() * share), extent.maxCoeff() * share);
  if (!(side_ > 0)) side_ = 1;
  columns_ = static_cast<int>(extent.x() / side_) + 1;
  rows_ = static_cast<int>(extent.y() / side_) + 1;
  const std::size_t buckets = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  points_in_ = linalg::make_adjacency(buckets, [&](const auto& add) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point from_lowest = points[i] - lowest_;
      add(bucket_index(from_lowest.y(), rows_) * columns_ + bucket_index(from_lowest.x(), columns_),
          static_cast<int>(i));
    }
  });
}

int NearPoints::bucket_index(double distance, int count) const {
  return static_cast<int>(std::clamp(std::floor(distance / side_), 0.0, static_cast<double>(count - 1)));
}

std::vector<int> NearPoints::about(const Point& place, double reach) const {
  const Point from_lowest = place - lowest_, around = Point::Constant(reach + rounding_of_distances * side_);
  const Point low = from_lowest - around, high = from_lowest + around;
  std::vector<int> found;
  for (int row = bucket_index(low.y(), rows_); row <= bucket_index(high.y(), rows_); ++row) {
    for (int column = bucket_index(low.x(), columns_); column <= bucket_index(high.x(), columns_); ++column) {
      const auto points = points_in_.of(row * columns_ + column);
      found.insert(found.end(), points.begin(), points.end());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace bempd::fracture

#include "geometry/measured_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bempd {

MeasuredPath::MeasuredPath(std::vector<Point> points) : points_(std::move(points)) {
  for (std::size_t i = 0; i < points_.size(); ++i)
    ways_.push_back(i == 0 ? 0 : ways_.back() + (points_[i] - points_[i - 1]).norm());
}

Point MeasuredPath::at(double way) const {
  std::size_t i = 0;
  while (i + 2 < points_.size() && way > ways_[i + 1]) ++i;
  return piece(i).at(std::clamp((way - ways_[i]) / (ways_[i + 1] - ways_[i]), 0.0, 1.0));
}

MeasuredPath::Nearest MeasuredPath::nearest(const Point& place) const {
  Nearest found{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < pieces(); ++i) {
    const double fraction = closest_fraction(piece(i), place), apart = (piece(i).at(fraction) - place).norm();
    if (apart < found.distance) found = {ways_[i] + fraction * (ways_[i + 1] - ways_[i]), apart};
  }
  return found;
}

std::vector<GridCrossing> crossings_of(const MeasuredPath& path, const BlockGrid& grid) {
  std::vector<GridCrossing> found;
  for (std::size_t i = 0; i < path.pieces(); ++i) {
    const Segment piece = path.piece(i);
    const Point start = (piece.start - grid.origin) / grid.size, end = (piece.end - grid.origin) / grid.size;
    for (const std::size_t axis : {0U, 1U}) {
      const auto a = static_cast<Eigen::Index>(axis);
      const double low = std::min(start[a], end[a]), high = std::max(start[a], end[a]);
      for (int line = static_cast<int>(std::ceil(low)); line < high; ++line) {
        const double fraction = (line - start[a]) / (end[a] - start[a]);
        const Point place = start + fraction * (end - start);
        found.push_back(
            {path.way(i) + fraction * piece.length(), axis, line, static_cast<int>(std::floor(place[1 - a]))});
      }
    }
  }
  std::ranges::sort(found, {}, &GridCrossing::way);
  return found;
}

}  // namespace bempd

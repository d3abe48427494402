#include "pd/outlined/outlined_points.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"

namespace bempd::pd {

using Eigen::Vector2i;

namespace {

// Half of a cell's diagonal, rounded up: the outline does not touch a cell whose middle is farther from the outline.
constexpr double half_diagonal = 0.7072;

}  // namespace

OutlinedPoints::OutlinedPoints(const Chords& chords, const LatticePlace& place, double gap, double deepest)
    : outline_count_(chords.count()),
      origin_(place.origin),
      turn_(Eigen::Rotation2Dd(place.angle)),
      points_(chords.nodes) {
  std::vector<Point> nodes;  // in coordinates of the lattice
  Box box;
  for (const Point& p : chords.nodes) {
    nodes.emplace_back(place_on_lattice(p));
    box.extend(nodes.back());
  }
  lower_ = box.min().array().floor().cast<int>().matrix();
  upper_ = box.max().array().ceil().cast<int>().matrix();
  columns_ = upper_.x() - lower_.x() + 1;
  const std::size_t size = static_cast<std::size_t>(columns_) * (upper_.y() - lower_.y() + 1);
  std::vector<char> inside(size, 0);
  mark_inside(nodes, chords, inside);
  const std::vector<double> depths = distances(nodes, chords, 0, deepest);
  const std::vector<double> middles = distances(nodes, chords, 0.5, 1);
  depth_.assign(points_.size(), 0.0);
  point_at_.assign(size, -1);
  clear_cell_.assign(size, 0);
  for (int y = lower_.y(); y <= upper_.y(); ++y) {
    for (int x = lower_.x(); x <= upper_.x(); ++x) {
      const Vector2i at(x, y);
      const std::size_t i = index(at);
      clear_cell_[i] = middles[i] >= half_diagonal;
      if (!inside[i] || depths[i] < gap) continue;
      point_at_[i] = count();
      points_.emplace_back(place.origin + turn_ * at.cast<double>());
      lattice_points_.push_back(at);
      depth_.push_back(depths[i]);
    }
  }
}

int OutlinedPoints::find_point(const Vector2i& at) const { return in_box(at) ? point_at_[index(at)] : -1; }

bool OutlinedPoints::has_cell(const Vector2i& at) const {
  return in_box(at) && clear_cell_[index(at)] && find_point(at) >= 0 && find_point(at + Vector2i(1, 0)) >= 0 &&
         find_point(at + Vector2i(0, 1)) >= 0 && find_point(at + Vector2i(1, 1)) >= 0;
}

// Marks the lattice points inside the outline, row by row: the points between an odd crossing of the row with the
// outline and the next crossing lie inside.
void OutlinedPoints::mark_inside(const std::vector<Point>& nodes, const Chords& chords,
                                 std::vector<char>& inside) const {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(upper_.y() - lower_.y()) + 1);
  for (const Chord& chord : chords.chords) {
    Point a = nodes[chord.first], b = nodes[chord.second];
    if (a.y() > b.y()) std::swap(a, b);
    for (int y = static_cast<int>(std::ceil(a.y())); y < b.y(); ++y)
      crossings[y - lower_.y()].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  for (int y = lower_.y(); y <= upper_.y(); ++y) {
    std::vector<double>& row = crossings[y - lower_.y()];
    std::sort(row.begin(), row.end());
    for (std::size_t k = 0; k + 1 < row.size(); k += 2)
      for (int x = static_cast<int>(std::ceil(row[k])); x <= row[k + 1]; ++x) inside[index({x, y})] = 1;
  }
}

std::vector<double> OutlinedPoints::distances(const std::vector<Point>& nodes, const Chords& chords, double shift,
                                              double deepest) const {
  const std::size_t size = static_cast<std::size_t>(columns_) * (upper_.y() - lower_.y() + 1);
  std::vector<double> least(size, deepest);
  const Point offset = Point::Constant(shift), reach = Point::Constant(deepest);
  for (const Chord& chord : chords.chords) {
    check_cancelled();
    const Segment segment{nodes[chord.first] - offset, nodes[chord.second] - offset};
    const Point low = segment.start.cwiseMin(segment.end) - reach, high = segment.start.cwiseMax(segment.end) + reach;
    const Vector2i from = low.array().ceil().cast<int>().matrix().cwiseMax(lower_);
    const Vector2i to = high.array().floor().cast<int>().matrix().cwiseMin(upper_);
    for (int y = from.y(); y <= to.y(); ++y) {
      for (int x = from.x(); x <= to.x(); ++x) {
        double& d = least[index({x, y})];
        d = std::min(d, distance(segment, Point(x, y)));
      }
    }
  }
  return least;
}

}  // namespace bempd::pd

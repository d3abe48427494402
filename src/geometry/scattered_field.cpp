#include "geometry/scattered_field.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "error.hpp"
#include "geometry/delaunay.hpp"

namespace bempd {

namespace {

// Barycentric coordinates of a place in a triangle; the least one is negative outside, all are -1 if the triangle has
// no area.
std::array<double, 3> shares_of(const std::array<Point, 3>& corners, const Point& place) {
  std::array<double, 3> shares{};
  const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(area > 0)) return {-1, -1, -1};
  for (std::size_t k = 0; k < 3; ++k)
    shares[k] = cross(corners[(k + 1) % 3] - place, corners[(k + 2) % 3] - place) / area;
  return shares;
}

}  // namespace

ScatteredField::ScatteredField(std::vector<Point> places, std::vector<double> values)
    : places_(std::move(places)), values_(std::move(values)) {
  triangulate();
}

void ScatteredField::triangulate() {
  Box box;
  for (const Point& place : places_) box.extend(place);
  Delaunay all(box);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const int number = all.insert(places_[k]);
    require(number == static_cast<int>(k), "places ", number + 1, " and ", k + 1, " are the same, (", places_[k].x(),
            ", ", places_[k].y(), "), to 1e-7 of the extent of all; leave out one of them");
  }
  std::vector<Box> boxes;
  for (const Delaunay::Triangle& triangle : all.triangles()) {
    if (!triangle.exists) continue;
    const bool inside = std::ranges::all_of(triangle.points, [](int point) { return point >= 0; });
    if (inside) {
      triangles_.push_back(triangle.points);
      Box around;
      for (const int point : triangle.points) around.extend(places_[static_cast<std::size_t>(point)]);
      boxes.push_back(around);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle.points[k], to = triangle.points[(k + 1) % 3];
      if (from >= 0 && to >= 0) border_.push_back({from, to});
    }
  }
  tree_ = BoxTree(boxes);
}

double ScatteredField::at(const Point& place) const {
  double found = std::numeric_limits<double>::quiet_NaN();
  const auto holds = [&](const Box& box) { return box.contains(place); };
  const auto take = [&](int number) {
    const std::array<int, 3>& points = triangles_[static_cast<std::size_t>(number)];
    std::array<Point, 3> corners;
    std::array<double, 3> values{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = places_[static_cast<std::size_t>(points[k])];
      values[k] = values_[static_cast<std::size_t>(points[k])];
    }
    const std::array<double, 3> shares = shares_of(corners, place);
    if (*std::ranges::min_element(shares) < 0) return false;
    const double sum = shares[0] * values[0] + shares[1] * values[1] + shares[2] * values[2];
    const auto [least, largest] = std::ranges::minmax(values);
    found = std::clamp(sum, least, largest);  // equal values are kept to the last digit
    return true;
  };
  return tree_.any(holds, take) ? found : on_border(place);
}

double ScatteredField::on_border(const Point& place) const {
  double nearest = std::numeric_limits<double>::infinity(), found = values_.front();
  for (const std::array<int, 2>& side : border_) {
    const auto from = static_cast<std::size_t>(side[0]), to = static_cast<std::size_t>(side[1]);
    const Point along = places_[to] - places_[from];
    const double part = std::clamp((place - places_[from]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double away = (places_[from] + part * along - place).squaredNorm();
    if (!(away < nearest)) continue;
    nearest = away;
    found = values_[from] + part * (values_[to] - values_[from]);
  }
  return found;
}

}  // namespace bempd

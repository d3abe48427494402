#include "pd/crack.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::pd {

namespace {

constexpr double tolerance = 1e-9;

double distance(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double square = ab.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
  return (a + t * ab - p).norm();
}

bool boxes_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point low = a.cwiseMin(b).cwiseMax(c.cwiseMin(d)), high = a.cwiseMax(b).cwiseMin(c.cwiseMax(d));
  return low.x() <= high.x() + tolerance && low.y() <= high.y() + tolerance;
}

// Segments that do not cross are closest at one of their ends.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!boxes_meet(a, b, c, d)) return false;
  const bool c_and_d_apart = cross(b - a, c - a) * cross(b - a, d - a) < 0;
  const bool a_and_b_apart = cross(d - c, a - c) * cross(d - c, b - c) < 0;
  if (c_and_d_apart && a_and_b_apart) return true;
  return distance(c, a, b) <= tolerance || distance(d, a, b) <= tolerance || distance(a, c, d) <= tolerance ||
         distance(b, c, d) <= tolerance;
}

// Calls `meets(from, to)` for the segments of the polyline; a single point is a segment of length zero.
template <class Meets>
bool any_segment(const std::vector<Point>& polyline, const Meets& meets) {
  if (polyline.size() == 1) return meets(polyline[0], polyline[0]);
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    if (meets(polyline[k], polyline[k + 1])) return true;
  }
  return false;
}

bool lies_on(const Point& p, const std::vector<Point>& polyline) {
  return any_segment(polyline, [&](const Point& c, const Point& d) { return distance(p, c, d) <= tolerance; });
}

// Whether the segment from c to d meets the bond from a to b in a place between its ends and not along it.
bool meets_between_ends(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!segments_meet(a, b, c, d)) return false;
  const double slope = cross(b - a, d - c), length = (b - a).norm();
  if (std::abs(slope) <= tolerance * length * (d - c).norm()) return false;
  const double place = cross(c - a, d - c) / slope * length;
  return place > tolerance && place < length - tolerance;
}

}  // namespace

std::vector<int> bonds_cut_by(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                              const std::vector<Point>& polyline, Touching touching) {
  std::vector<char> bridges(points.size(), 0);
  if (touching == Touching::of_ends_keeps) {
    for (const int i : points_on(points, polyline)) bridges[i] = 1;
  }
  std::vector<int> cut;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const Point &from = points[bonds[b].first], &to = points[bonds[b].second];
    const bool end_on_crack = bridges[bonds[b].first] || bridges[bonds[b].second];
    const auto meets = [&](const Point& c, const Point& d) {
      return end_on_crack ? meets_between_ends(from, to, c, d) : segments_meet(from, to, c, d);
    };
    if (any_segment(polyline, meets)) cut.push_back(static_cast<int>(b));
  }
  return cut;
}

std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& polyline) {
  std::vector<int> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (lies_on(points[i], polyline)) found.push_back(static_cast<int>(i));
  }
  return found;
}

}  // namespace bempd::pd

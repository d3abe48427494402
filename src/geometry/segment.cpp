#include "geometry/segment.hpp"

#include <algorithm>
#include <limits>

namespace bempd {

Point Segment::at(double fraction) const {
  // The point is computed from the nearer end, so that both ends are exact.
  return fraction < 0.5 ? Point(start + fraction * direction()) : Point(end - (1 - fraction) * direction());
}

double closest_fraction(const Segment& segment, const Point& p) {
  const Point d = segment.direction();
  const double length_squared = d.squaredNorm();
  if (!(length_squared > 0)) return 0;
  return std::clamp((p - segment.start).dot(d) / length_squared, 0.0, 1.0);
}

double distance(const Segment& segment, const Point& p) {
  return (p - segment.at(closest_fraction(segment, p))).norm();
}

double polyline_length(const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += (points[i + 1] - points[i]).norm();
  return sum;
}

double polyline_distance(const std::vector<Point>& points, const Point& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    least = std::min(least, distance(Segment{points[i], points[i + 1]}, place));
  return least;
}

std::optional<Crossing> proper_crossing(const Segment& a, const Segment& b) {
  const Point u = a.direction(), v = b.direction();
  const double start_side = cross(v, a.start - b.start), end_side = cross(v, a.end - b.start);
  const double other_start_side = cross(u, b.start - a.start), other_end_side = cross(u, b.end - a.start);
  const auto opposite = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  if (!opposite(start_side, end_side) || !opposite(other_start_side, other_end_side)) return std::nullopt;
  return Crossing{start_side / (start_side - end_side), other_start_side / (other_start_side - other_end_side)};
}

Approach closest_approach(const Segment& a, const Segment& b) {
  if (const auto crossing = proper_crossing(a, b)) return {0, a.at(crossing->fraction_a)};
  // Segments that do not cross are closest at one of their four ends.
  Approach best{-1, a.start};
  const auto consider = [&best](const Segment& segment, const Point& end) {
    const Point foot = segment.at(closest_fraction(segment, end));
    const double gap = (foot - end).norm();
    if (best.distance < 0 || gap < best.distance) best = {gap, 0.5 * (foot + end)};
  };
  consider(b, a.start);
  consider(b, a.end);
  consider(a, b.start);
  consider(a, b.end);
  return best;
}

}  // namespace bempd

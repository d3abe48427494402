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

}  // namespace

std::vector<int> bonds_cut_by(const CellLattice& lattice, const std::vector<Bond>& bonds,
                              const std::vector<Point>& polyline) {
  std::vector<int> cut;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const Point from = lattice.point(bonds[b].first).cast<double>(), to = lattice.point(bonds[b].second).cast<double>();
    const auto meets = [&](const Point& c, const Point& d) { return segments_meet(from, to, c, d); };
    if (any_segment(polyline, meets)) cut.push_back(static_cast<int>(b));
  }
  return cut;
}

std::vector<int> points_on(const CellLattice& lattice, const std::vector<Point>& polyline) {
  std::vector<int> found;
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Point p = lattice.point(i).cast<double>();
    const auto meets = [&](const Point& c, const Point& d) { return distance(p, c, d) <= tolerance; };
    if (any_segment(polyline, meets)) found.push_back(i);
  }
  return found;
}

}  // namespace bempd::pd

#include "pd/crack.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"
#include "geometry/box_tree.hpp"

namespace bempd::pd {

namespace {

constexpr double tolerance = 1e-9;

// Points or bonds that are gone through, in microseconds, before the host's wish to stop is looked at again.
constexpr std::size_t between_polls = 256;

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

// The segments of a polyline; a single point is a segment of length zero.
class Polyline {
 public:
  explicit Polyline(const std::vector<Point>& vertices) : vertices_(vertices) {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < count(); ++k) {
      boxes.emplace_back(vertices[k]);
      boxes.back().extend(end(k));
    }
    tree_ = BoxTree(boxes);
  }

  // Whether `meets(from, to)` holds for a segment; asked only for those that come within the tolerance of the line
  // from a to b.
  template <class Meets>
  bool any_near(const Point& a, const Point& b, const Meets& meets) const {
    Box around(a);
    around.extend(b);
    // Twice the tolerance, and the rounding of what is computed here and there from coordinates far away.
    const double margin =
        2 * tolerance + 1e-14 * std::max(around.min().cwiseAbs().maxCoeff(), around.max().cwiseAbs().maxCoeff());
    around = Box(around.min().array() - margin, around.max().array() + margin);
    const Point normal(a.y() - b.y(), b.x() - a.x());
    const auto is_near = [&](const Box& box) {
      if (!box.intersects(around)) return false;
      const Point half = 0.5 * box.sizes(), centre = box.min() + half;
      const double reach = normal.cwiseAbs().dot(half + Point::Constant(margin + 1e-14 * half.maxCoeff()));
      return std::abs(normal.dot(centre - a)) <= reach;
    };
    return tree_.any(is_near, [&](int k) { return meets(vertices_[k], end(k)); });
  }

 private:
  std::size_t count() const { return vertices_.size() > 1 ? vertices_.size() - 1 : vertices_.size(); }
  const Point& end(std::size_t k) const { return vertices_[std::min(k + 1, vertices_.size() - 1)]; }

  const std::vector<Point>& vertices_;
  BoxTree tree_;
};

std::vector<int> points_on(const std::vector<Point>& points, const Polyline& polyline) {
  std::vector<int> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % between_polls == 0) check_cancelled();
    const Point& p = points[i];
    const auto meets = [&](const Point& c, const Point& d) { return distance(p, c, d) <= tolerance; };
    if (polyline.any_near(p, p, meets)) found.push_back(static_cast<int>(i));
  }
  return found;
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
                              const std::vector<Point>& vertices, Touching touching) {
  const Polyline polyline(vertices);
  std::vector<char> bridges(points.size(), 0);
  if (touching == Touching::of_ends_keeps) {
    for (const int i : points_on(points, polyline)) bridges[i] = 1;
  }
  std::vector<int> cut;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (b % between_polls == 0) check_cancelled();
    const Point &from = points[bonds[b].first], &to = points[bonds[b].second];
    const bool end_on_crack = bridges[bonds[b].first] || bridges[bonds[b].second];
    const auto meets = [&](const Point& c, const Point& d) {
      return end_on_crack ? meets_between_ends(from, to, c, d) : segments_meet(from, to, c, d);
    };
    if (polyline.any_near(from, to, meets)) cut.push_back(static_cast<int>(b));
  }
  return cut;
}

std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices) {
  return points_on(points, Polyline(vertices));
}

}  // namespace bempd::pd

#include "pd/crack.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "cancellation.hpp"
#include "geometry/box_tree.hpp"

namespace bempd::pd {

namespace {

constexpr double tolerance = 1e-9;

// Number of points or bonds (some microseconds of work) between two checks whether the host has asked to cancel.
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

// Whether two segments come closer than the tolerance. If they do not cross, one of the four ends is the closest point.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!boxes_meet(a, b, c, d)) return false;
  const bool c_and_d_apart = cross(b - a, c - a) * cross(b - a, d - a) < 0;
  const bool a_and_b_apart = cross(d - c, a - c) * cross(d - c, b - c) < 0;
  if (c_and_d_apart && a_and_b_apart) return true;
  return distance(c, a, b) <= tolerance || distance(d, a, b) <= tolerance || distance(a, c, d) <= tolerance ||
         distance(b, c, d) <= tolerance;
}

// Segments of a polyline; a single point is a segment of length zero.
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

  // Whether meets(from, to) holds for some segment of the polyline. The function `meets` is called only for segments
  // that come within about the tolerance of the segment from a to b.
  template <class Meets>
  bool any_near(const Point& a, const Point& b, const Meets& meets) const {
    Box around(a);
    around.extend(b);
    // The margin is twice the tolerance, plus the rounding errors of coordinates far from the origin.
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

// Distance along a crack's line, in spacings, below which two places count as the same.
constexpr double same_place = 1e-6;

// Crossing of a bond with the straight line of a crack. `place` is the distance of the crossing ahead of the tip,
// `weight` the bond's stiffness against displacements across the line.
struct LineCrossing {
  int bond;
  double place, weight;
};

// Crossings of bonds with the line through `tip` along `direction`, ordered along the line, up to the distance `reach`
// ahead of and behind the tip. Places are rounded, so that the order of equal places does not depend on the unit of
// length.
std::vector<LineCrossing> crossings_of_line(const std::vector<Point>& points, const std::vector<Bond>& bonds,
                                            const Point& tip, const Point& direction, double reach) {
  std::vector<LineCrossing> found;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const Bond& bond = bonds[b];
    const Point from = points[bond.first] - tip, to = points[bond.second] - tip;
    const double below = cross(direction, from), above = cross(direction, to);
    if (below * above >= 0) continue;
    const double part = below / (below - above);
    const double place = same_place * std::round(direction.dot(from + part * (to - from)) / same_place);
    if (std::abs(place) > reach) continue;
    const double across = above - below;
    found.push_back({static_cast<int>(b), place, bond.stiffness * across * across / (to - from).squaredNorm()});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::pair(a.place, a.bond) < std::pair(b.place, b.bond); });
  return found;
}

// Coefficients a and b of the linear function a + b s that best fits the sum of the weights of all crossings before the
// place s along the crack's line. The function stands for crossings that are spread evenly. Places near the tip, which
// is the middle of the fitted range, have the largest weights in the fit.
Eigen::Vector2d fit_of_even_crossings(const std::vector<LineCrossing>& crossings, double reach) {
  constexpr int samples = 400;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double sum = 0;
  auto next = crossings.begin();
  for (int k = 0; k < samples; ++k) {
    const double t = (2 * k + 1.0) / samples - 1, place = reach * t;
    for (; next != crossings.end() && next->place <= place + same_place / 2; ++next) sum += next->weight;
    const double weight = (1 - t * t) * (1 - t * t);
    const Eigen::Vector2d row(1, place);
    normal += weight * row * row.transpose();
    right += weight * sum * row;
  }
  return normal.inverse() * right;
}

// Whether the segment from c to d meets the bond from a to b at a point between the bond's ends, without being parallel
// to the bond.
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
  if (touching == Touching::spares_bonds_ending_on_it) {
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

CutEnd cut_end_for_tip(const std::vector<Point>& points, const std::vector<Bond>& bonds, const Point& tip,
                       const Point& direction, int horizon_ratio, double backward) {
  constexpr double largest_move = 1.5, whole = 1e-3;
  constexpr double weakened_more = 0.03;  // spacings by which a weakened bond counts more than its share, measured
  constexpr std::size_t fewest = 20;
  double reach = 3 * horizon_ratio;
  std::vector<LineCrossing> crossings = crossings_of_line(points, bonds, tip, direction, reach);
  if (crossings.size() < fewest) return {tip, {}};
  reach = std::min({reach, -crossings.front().place, crossings.back().place});
  if (reach < 1) return {tip, {}};
  std::erase_if(crossings, [&](const LineCrossing& c) { return std::abs(c.place) > reach; });
  const Eigen::Vector2d even = fit_of_even_crossings(crossings, reach);
  const double wanted = even[0] - (effective_tip_ahead(horizon_ratio) - weakened_more) * even[1];
  double sum = 0, before = crossings.front().place - 1;
  for (std::size_t k = 0, next = 0; k < crossings.size(); k = next) {
    const double place = crossings[k].place;
    CutEnd found;
    double there = 0;
    for (; next < crossings.size() && crossings[next].place - place < same_place / 2; ++next) {
      there += crossings[next].weight;
      found.weakened.push_back(crossings[next].bond);
    }
    const double end = 0.5 * (before + place);
    if (sum + (1 - whole) * there > wanted) {
      if (end < -std::min(backward, largest_move) || end > largest_move) break;
      found.end = tip + end * direction;
      found.even_ahead = -effective_tip_ahead(horizon_ratio) - end;
      found.share = 1 - std::max(0.0, wanted - sum) / there;
      if (found.share > 1 - whole) found.weakened.clear();
      return found;
    }
    sum += there, before = crossings[next - 1].place;
  }
  return {tip, {}};
}

std::vector<int> points_on(const std::vector<Point>& points, const std::vector<Point>& vertices) {
  return points_on(points, Polyline(vertices));
}

}  // namespace bempd::pd

#include "geometry/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/turning.hpp"

namespace bempd {

namespace {

// Fraction of the arc's length at which its circle is closest to `p`, below 0 or above 1 beyond the ends of the arc.
// The fractions reach half a turn of the circle to either side of the arc's middle.
double fraction_on_circle(const Arc& arc, const Point& p) {
  const Point centre = arc.centre(), middle = arc.at(0.5) - centre, r = p - centre;
  return 0.5 + std::atan2(cross(middle, r), middle.dot(r)) / arc.sweep;
}

double fraction_on_line(const Arc& line, const Point& p) {
  const Point d = line.end - line.start;
  return (p - line.start).dot(d) / d.squaredNorm();
}

double fraction_beyond_ends(const Arc& arc, const Point& p) {
  return arc.straight() ? fraction_on_line(arc, p) : fraction_on_circle(arc, p);
}

// Points that the circle of `arc` has in common with the straight line or the circle of `other`. They lie half a common
// chord on either side of that chord's middle (`foot`). Circles that miss each other by rounding errors count as
// touching.
std::vector<Point> common_points(const Arc& arc, const Arc& other) {
  const Point centre = arc.centre();
  const double radius = (arc.start - centre).norm();
  Point foot, along;
  double square;
  if (other.straight()) {
    along = (other.end - other.start).normalized();
    foot = other.start + (centre - other.start).dot(along) * along;
    square = radius * radius - (foot - centre).squaredNorm();
  } else {
    const Point between = other.centre() - centre;
    const double distance = between.norm(), other_radius = (other.start - other.centre()).norm();
    if (!(distance > 1e-12 * radius)) return {};
    const double reach = 0.5 * (distance + (radius - other_radius) * (radius + other_radius) / distance);
    along = left_of(between / distance);
    foot = centre + reach * between / distance;
    square = radius * radius - reach * reach;
  }
  if (square < -1e-12 * radius * radius) return {};
  const double half = std::sqrt(std::max(square, 0.0));
  return {foot - half * along, foot + half * along};
}

// Piece of an arc. The distance of two pieces is at least that of their chords less reach() (the height over the chord)
// of both.
struct Piece {
  Arc arc;
  double reach() const { return std::abs(arc.sagitta()); }
};

std::optional<Point> search_contact(const Piece& a, const Piece& b, double tolerance, int depth) {
  const Approach approach = closest_approach(a.arc.chord(), b.arc.chord());
  if (approach.distance > a.reach() + b.reach() + tolerance) return std::nullopt;
  constexpr int max_depth = 80;
  if (a.reach() + b.reach() <= 0.01 * tolerance || depth == max_depth) {
    if (approach.distance <= tolerance) return approach.where;
    return std::nullopt;
  }
  const bool halve_a = a.reach() >= b.reach();
  const Arc& wider = halve_a ? a.arc : b.arc;
  for (const Piece& half : {Piece{wider.part(0, 0.5)}, Piece{wider.part(0.5, 1)}})
    if (const auto found =
            halve_a ? search_contact(half, b, tolerance, depth + 1) : search_contact(a, half, tolerance, depth + 1))
      return found;
  return std::nullopt;
}

}  // namespace

double Arc::length() const {
  const double chord_length = (end - start).norm(), half = 0.5 * sweep;
  return straight() ? chord_length : chord_length * half / std::sin(half);
}

Point Arc::at(double fraction) const {
  if (straight()) return chord().at(fraction);
  // The point is computed from the nearer end, so that both ends are exact.
  const auto from = [](const Point& origin, const Point& towards, double turning, double part) -> Point {
    const double ratio = std::sin(0.5 * part * turning) / std::sin(0.5 * turning);
    return origin + ratio * turned(towards - origin, -0.5 * (1 - part) * turning);
  };
  return fraction < 0.5 ? from(start, end, sweep, fraction) : from(end, start, -sweep, 1 - fraction);
}

Point Arc::tangent(double fraction) const { return turned((end - start).normalized(), (fraction - 0.5) * sweep); }

Arc Arc::part(double from, double to) const { return {at(from), at(to), (to - from) * sweep}; }

double Arc::sagitta() const { return 0.5 * (end - start).norm() * std::tan(0.25 * sweep); }

Point Arc::centre() const {
  const Point d = end - start;
  return 0.5 * (start + end) + 0.5 / std::tan(0.5 * sweep) * left_of(d);
}

std::optional<Arc> arc_through(const Point& start, const Point& between, const Point& end) {
  const Point a = between - start, b = end - between;
  const double turning = cross(a, b), along = a.dot(b);
  // The polyline through the three places turns at `between` by half the arc's sweep.
  const double half = std::atan2(turning, along);
  constexpr double straight_enough = 1e-12;
  if (!(a.squaredNorm() > 0 && b.squaredNorm() > 0)) return std::nullopt;
  if (std::numbers::pi - std::abs(half) < 1e-6) return std::nullopt;
  return Arc{start, end, std::abs(half) < straight_enough ? 0.0 : 2 * half};
}

// Lower bound from a circle around the middle of the chord that contains the arc. The circle goes through both ends, or
// through the arc's far point if the arc is larger than half a circle.
double least_distance(const Arc& arc, const Point& p) {
  const Point half = 0.5 * (arc.end - arc.start);
  double radius = half.norm();
  if (std::abs(arc.sweep) > std::numbers::pi) radius = std::max(radius, std::abs(arc.sagitta()));
  return (p - arc.start - half).norm() - radius;
}

double closest_fraction(const Arc& arc, const Point& p) {
  if (arc.straight()) return closest_fraction(arc.chord(), p);
  const double length = arc.length(), curvature = arc.sweep / length;
  constexpr double nearly_straight = 1e-3;
  double fraction =
      std::abs(arc.sweep) < nearly_straight ? fraction_on_line({arc.start, arc.end}, p) : fraction_on_circle(arc, p);
  if (fraction <= 0 || fraction >= 1) {
    // One end of the arc is the closest place if the nearest place of the circle lies beyond the arc.
    const double to_start = (p - arc.start).squaredNorm(), to_end = (p - arc.end).squaredNorm();
    if (std::abs(arc.sweep) >= nearly_straight) return to_start <= to_end ? 0.0 : 1.0;
    fraction = std::clamp(fraction, 0.0, 1.0);
  }
  // Newton's method improves the fraction: the centre of a flat arc is far away and known to few digits.
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Point r = p - arc.at(fraction), t = arc.tangent(fraction);
    const double stretch = 1 - curvature * cross(t, r);
    if (!(stretch > 0.1)) break;
    fraction = std::clamp(fraction + r.dot(t) / (stretch * length), 0.0, 1.0);
  }
  return fraction;
}

bool in_circular_segment(const Arc& arc, const Point& p) {
  if (arc.straight()) return false;
  const Point d = arc.end - arc.start;
  const double left = cross(d, p - arc.start);
  if ((arc.sweep > 0) == (left > 0)) return false;
  // The place lies within the circle if the arc's ends appear from it under more than the inscribed angle. This test
  // does not need the circle's centre, which is far away for a flat arc.
  return (p - arc.start).dot(p - arc.end) < left / std::tan(0.5 * arc.sweep);
}

std::vector<Crossing> meeting_points(const Arc& a, const Arc& b) {
  std::vector<Crossing> found;
  if (a.straight() && b.straight()) {
    if (const auto crossing = proper_crossing(a.chord(), b.chord())) found.push_back(*crossing);
    return found;
  }
  for (const Point& p : a.straight() ? common_points(b, a) : common_points(a, b)) {
    const Crossing crossing{fraction_beyond_ends(a, p), fraction_beyond_ends(b, p)};
    const auto within = [](double fraction) { return fraction >= 0 && fraction <= 1; };
    if (within(crossing.fraction_a) && within(crossing.fraction_b)) found.push_back(crossing);
  }
  return found;
}

std::optional<Point> find_contact(const Arc& a, const Arc& b, double tolerance) {
  return search_contact({a}, {b}, tolerance, 0);
}

std::array<Arc, 2> biarc(const Point& start, const Point& start_tangent, const Point& end, const Point& end_tangent) {
  // The joint is start + d t0 + d e, with the unit tangents t0 and t1 at the ends and the length d of both tangents,
  // which meet the common tangent at start + d t0 and end - d t1. These two places are 2 d apart,
  //   |end - start - d (t0 + t1)| = 2 d,
  // and e is the unit vector from the first to the second.
  const Point v = end - start, t = start_tangent + end_tangent;
  const double a = 2 * (1 - start_tangent.dot(end_tangent)), b = 2 * v.dot(t), c = -v.squaredNorm();
  const double d = -2 * c / (b + std::sqrt(b * b - 4 * a * c));
  const Point joint = 0.5 * (start + end + d * (start_tangent - end_tangent));
  const auto turning = [](const Point& tangent, const Point& chord) {
    const double half = std::atan2(cross(tangent, chord), tangent.dot(chord));
    constexpr double straight_enough = 1e-12;
    return std::abs(half) < straight_enough ? 0.0 : 2 * half;
  };
  return {Arc{start, joint, turning(start_tangent, joint - start)},
          Arc{joint, end, -turning(-end_tangent, joint - end)}};
}

}  // namespace bempd

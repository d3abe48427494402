#include "geometry/material_cut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "geometry/turning.hpp"

namespace bempd {

namespace {

// Growth of the length of a cut's elements per distance from the boundary.
constexpr double growth_with_distance = 0.35;
// Growth of the length of a cut's elements per distance from cracks.
constexpr double growth_with_distance_from_cracks = 0.2;
// Ratio of the smallest distance of a cut from an element on a crack to the element's length.
constexpr double least_clearance_of_cracks = 1;
// Ratio of the smallest distance of a cut from a side of the boundary to the side's length.
constexpr double least_clearance = 0.3;
// Smallest angles between a cut and the boundary at its ends [rad]: the first is preferred, the others are accepted if
// no cut is found with larger angles.
constexpr std::array<double, 3> least_angles{0.8, 0.5, 0.35};
// Largest angle inside the material at which a cut may end [rad]. Corners with larger angles have singular stresses,
// which a cut must not meet.
constexpr double largest_corner = 1.3 * std::numbers::pi;
// Shares of a subdomain's elements on one side of the straight lines that are tried for a cut: the first line has half
// of the elements on either side, the next lines deviate from half in steps of `step_of_share`, up to
// `farthest_from_half`.
constexpr double farthest_from_half = 0.2, step_of_share = 0.02;
// Number of possible divisions of a subdomain after which no more divisions are searched.
constexpr int enough_divisions = 5;

// Angle from one direction to another, counter-clockwise, 0 to 2 pi.
double angle_between(const Point& from, const Point& to) {
  const double angle = std::atan2(cross(from, to), from.dot(to));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

// Lower bound on the distance of two segments: the distance of the circles around them.
double least_distance(const Segment& a, const Segment& b) {
  return (a.at(0.5) - b.at(0.5)).norm() - 0.5 * (a.length() + b.length());
}

}  // namespace

bool is_clear_of(const Stations& cut, const std::vector<Stations>& cracks) {
  for (const Stations& crack : cracks)
    for (std::size_t e = 0; e + 1 < crack.size(); ++e) {
      const Segment on_crack{crack[e], crack[e + 1]};
      const Segment whole{cut.front(), cut.back()};
      if (least_distance(whole, on_crack) > 1.01 * whole.length() / growth_with_distance_from_cracks) continue;
      const double gap = closest_approach(whole, on_crack).distance;
      if (gap > whole.length() / growth_with_distance_from_cracks) continue;
      for (std::size_t k = 0; k + 1 < cut.size(); ++k) {
        const Segment own{cut[k], cut[k + 1]};
        const double near = closest_approach(own, on_crack).distance;
        if (proper_crossing(own, on_crack) || near < least_clearance_of_cracks * on_crack.length() ||
            own.length() > on_crack.length() + growth_with_distance_from_cracks * near)
          return false;
      }
    }
  return true;
}

MaterialCutSearch::MaterialCutSearch(const SubdomainLoops& loops, const std::vector<Point>& positions,
                                     const std::vector<Stations>& cracks)
    : positions_(positions), uses_(positions.size(), 0) {
  for (const SubdomainLoop& loop : loops) {
    const int first = static_cast<int>(sides_.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      sides_.push_back(loop[i]);
      before_.push_back(first + (i + count - 1) % count);
      after_.push_back(first + (i + 1) % count);
      loop_size_.push_back(count);
      ++uses_[loop[i].nodes[0]];
    }
  }
  std::vector<Box> boxes;
  for (int side = 0; side < static_cast<int>(sides_.size()); ++side) {
    Box box(start(side), start(side));
    box.extend(end(side));
    boxes.push_back(box);
    box_.extend(box);
  }
  tree_ = BoxTree(boxes);
  for (const Stations& crack : cracks)
    for (std::size_t e = 0; e + 1 < crack.size(); ++e) on_cracks_.push_back({crack[e], crack[e + 1]});
}

int MaterialCutSearch::longer_axis() const { return box_.sizes().x() >= box_.sizes().y() ? 0 : 1; }

std::optional<MaterialCutSearch::Division> MaterialCutSearch::along(int axis) const {
  std::vector<double> middles;
  for (const SubdomainSide& side : sides_) middles.push_back(positions_[side.nodes[1]][axis]);
  std::sort(middles.begin(), middles.end());
  std::optional<Division> best;
  int found = 0;
  for (int k = 0; k * step_of_share <= farthest_from_half && found < enough_divisions; ++k) {
    for (const double sign : {1.0, -1.0}) {
      if (k == 0 && sign < 0) continue;
      const double off = sign * k * step_of_share;
      const auto place = static_cast<std::size_t>((0.5 + off) * static_cast<double>(middles.size()));
      if (place == 0 || place >= middles.size()) continue;
      std::optional<std::vector<MaterialCut>> cuts = cuts_on(axis, 0.5 * (middles[place - 1] + middles[place]));
      if (!cuts) continue;
      ++found;
      double elements = 0;
      for (const MaterialCut& cut : *cuts) elements += static_cast<double>(cut.stations.size()) - 1;
      const double cost = elements * (1 + 4 * off * off);
      if (!best || cost < best->cost) best = Division{std::move(*cuts), cost};
    }
  }
  return best;
}

// Sides that the straight line x = at (axis 0) or y = at (axis 1) crosses, in order along it. Of the two ends of a side
// only the one with the smaller coordinate belongs to the side, so that the line crosses every loop an even number of
// times.
std::vector<MaterialCutSearch::Hit> MaterialCutSearch::hits(int axis, double at) const {
  std::vector<Hit> found;
  for (int side = 0; side < static_cast<int>(sides_.size()); ++side) {
    const Point &a = start(side), &b = end(side);
    if ((a[axis] > at) == (b[axis] > at)) continue;
    const double share = (at - a[axis]) / (b[axis] - a[axis]);
    found.push_back({a[1 - axis] + share * (b[1 - axis] - a[1 - axis]), side});
  }
  std::sort(found.begin(), found.end(), [](const Hit& a, const Hit& b) { return a.along < b.along; });
  return found;
}

std::optional<std::vector<MaterialCut>> MaterialCutSearch::cuts_on(int axis, double at) const {
  const std::vector<Hit> on_line = hits(axis, at);
  if (on_line.empty()) return std::nullopt;
  std::vector<MaterialCut> cuts;
  for (std::size_t i = 0; i + 1 < on_line.size(); i += 2) {
    std::optional<MaterialCut> cut = cut_between(on_line[i], on_line[i + 1], cuts);
    if (!cut) return std::nullopt;
    cuts.push_back(std::move(*cut));
  }
  for (MaterialCut& cut : cuts) {
    cut.stations = {positions_[cut.from]};
    divide(positions_[cut.from], positions_[cut.to], 0, cut.stations);
  }
  return cuts;
}

// Sides whose starts are candidates for the end of a cut near `side`, the nearest first.
std::vector<int> MaterialCutSearch::ends_near(int side) const {
  const int reach = std::clamp(loop_size_[side] / 8, 1, 12);
  std::vector<int> found;
  int back = side, ahead = after_[side];
  for (int i = 0; i < reach; ++i) {
    for (const int one : {back, ahead})
      if (uses_[sides_[one].nodes[0]] == 1 && corner(one) <= largest_corner) found.push_back(one);
    back = before_[back], ahead = after_[ahead];
  }
  return found;
}

// Directions at the start of a side along the boundary, forwards and backwards.
std::array<Point, 2> MaterialCutSearch::directions_at(int side) const {
  const int before = before_[side];
  return {turned(end(side) - start(side), -0.5 * sides_[side].sweep),
          turned(start(before) - end(before), 0.5 * sides_[before].sweep)};
}

double MaterialCutSearch::corner(int side) const {
  const auto [forwards, backwards] = directions_at(side);
  return angle_between(forwards, backwards);
}

double MaterialCutSearch::least_angle(int side, const Point& direction) const {
  const double angle = angle_between(directions_at(side)[0], direction);
  return std::min(angle, corner(side) - angle);
}

std::optional<MaterialCut> MaterialCutSearch::cut_between(const Hit& a, const Hit& b,
                                                          const std::vector<MaterialCut>& others) const {
  const std::vector<int> from = ends_near(a.side), to = ends_near(b.side);
  const auto fits = [&](int one, int other, double least) {
    const int p = sides_[one].nodes[0], q = sides_[other].nodes[0];
    if (p == q) return false;
    for (const MaterialCut& cut : others)
      for (const int taken : {cut.from, cut.to})
        if (taken == p || taken == q) return false;
    const Point way = positions_[q] - positions_[p];
    return least_angle(one, way) >= least && least_angle(other, -way) >= least && is_clear(p, q, others);
  };
  for (const double least : least_angles) {
    for (std::size_t sum = 0; sum + 1 < from.size() + to.size(); ++sum) {
      for (std::size_t i = 0; i <= sum && i < from.size(); ++i) {
        if (sum - i >= to.size() || !fits(from[i], to[sum - i], least)) continue;
        return MaterialCut{sides_[from[i]].nodes[0], sides_[to[sum - i]].nodes[0], {}};
      }
    }
  }
  return std::nullopt;
}

// Whether a cut keeps its distance from cracks and from all sides except those at its ends, and crosses no other cut.
bool MaterialCutSearch::is_clear(int from, int to, const std::vector<MaterialCut>& others) const {
  const Segment cut{positions_[from], positions_[to]};
  for (const MaterialCut& other : others)
    if (proper_crossing(cut, {positions_[other.from], positions_[other.to]})) return false;
  if (!keeps_off_cracks(cut)) return false;
  Box around(cut.start, cut.start);
  around.extend(cut.end);
  const auto is_near = [&](const Box& box) {
    const double reach = least_clearance * box.diagonal().norm();
    return around.intersects(Box(box.min().array() - reach, box.max().array() + reach));
  };
  return !tree_.any(is_near, [&](int side) {
    const auto& nodes = sides_[side].nodes;
    if (nodes[0] == from || nodes[0] == to || nodes[2] == from || nodes[2] == to) return false;
    const Arc arc{start(side), end(side), sides_[side].sweep};
    const Segment chord = arc.chord();
    return proper_crossing(cut, chord).has_value() ||
           closest_approach(cut, chord).distance < least_clearance * chord.length() + std::abs(arc.sagitta());
  });
}

bool MaterialCutSearch::keeps_off_cracks(const Segment& cut) const {
  return std::none_of(on_cracks_.begin(), on_cracks_.end(), [&](const Segment& element) {
    return proper_crossing(cut, element).has_value() ||
           closest_approach(cut, element).distance < least_clearance_of_cracks * element.length();
  });
}

// Length that an element of a cut should have at a place: the least value of (length + growth * distance from the
// place) over all sides and all elements on cracks.
double MaterialCutSearch::element_length_at(const Point& place) const {
  const double whole = 2 * box_.diagonal().norm();
  double least = growth_with_distance * whole + whole;
  const auto shorten = [&](int side) {
    const Segment chord{start(side), end(side)};
    least = std::min(least, chord.length() + growth_with_distance * distance(chord, place));
    return false;
  };
  for (double reach = 1e-3 * whole; reach <= whole; reach *= 2) {
    const double known = std::min(reach, least / growth_with_distance);
    const Box around(place.array() - known, place.array() + known);
    tree_.any([&](const Box& box) { return box.intersects(around); }, shorten);
    if (least <= growth_with_distance * reach) break;
  }
  for (const Segment& element : on_cracks_)
    least = std::min(least, element.length() + growth_with_distance_from_cracks * distance(element, place));
  return least;
}

void MaterialCutSearch::divide(const Point& from, const Point& to, int depth, std::vector<Point>& stations) const {
  constexpr int deepest = 40;
  const Point middle = 0.5 * (from + to);
  if (depth == deepest || (to - from).norm() <= element_length_at(middle)) return stations.push_back(to);
  divide(from, middle, depth + 1, stations);
  divide(middle, to, depth + 1, stations);
}

}  // namespace bempd

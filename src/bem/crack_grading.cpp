#include "bem/crack_grading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error.hpp"
#include "geometry/halving.hpp"
#include "geometry/segment.hpp"

namespace bempd::bem {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest_distance = 1e100;  // in place of infinity, for boxes
constexpr std::size_t many_edges = 100;     // from this number on, a tree finds near edges faster than a loop

// Limit on a ratio for a crack line that meets a neighbour (crack or edge) at a joint: the distance of a point of the
// line from the neighbour, over its distance along the line from the joint. Below the limit, line and neighbour count
// as running beside each other.
constexpr double aside = 0.3;

// Turn of a crack line at a corner [rad] below which the corner counts as a part of a curve drawn as a polygon.
constexpr double least_kink = 0.2;

constexpr int most_halvings = 40;

// Largest length of an element over its distance to the next crack, edge or tip; `longest_at_tip` for elements that end
// at a tip, because their openings split the energy release rate into modes. Measured on infinitesimal kinks, K_II is
// wrong by 4e-4 with a limit of 0.5, by 2e-5 with 0.25.
constexpr double longest = 0.5, longest_at_tip = 0.25;

// Largest length of an element along a narrow gap, in gap widths, and its growth per distance from the gap's ends. The
// strip between the faces bends: openings are right to 4e-5 with elements of two widths, to 6e-4 with four, if the
// elements at the ends of the gap are short.
constexpr double longest_along_gap = 2, growth_along_gap = 0.25;
// Largest length of elements along a gap over the element length without a gap, on cracks and on the boundary. The
// limit matters along wide gaps, where longer elements would save little.
constexpr double part_along_crack = 0.125, part_along_boundary = 0.25;

// Growth of the element length per distance from a crack mouth on an edge with fixed node spacing; each element is then
// 1.6 times as long as the one before.
constexpr double growth_from_rows = 0.6;

Segment segment(const CrackLine& line, std::size_t i) { return {line.points[i], line.points[i + 1]}; }

double distance(const CrackLine& line, const Point& x) {
  double least = infinite;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    least = std::min(least, bempd::distance(segment(line, i), x));
  return least;
}

double given_length(const CrackLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    if (!line.grown[i]) sum += segment(line, i).length();
  return sum;
}

double turn(const CrackLine& line, std::size_t vertex) {
  const Point before = segment(line, vertex - 1).direction(), after = segment(line, vertex).direction();
  return std::abs(std::atan2(cross(before, after), before.dot(after)));
}

// Largest number of elements on one crack line or piece of the boundary; only a gap made by mistake would need more.
constexpr std::size_t most_elements = 100000;

void require_few(const std::vector<double>& ends) {
  require(ends.size() < most_elements,
          "a crack comes so close to another one or to the boundary that they would need "
          "more than ",
          most_elements, " elements: widen the gap between them, or close it");
}

}  // namespace

CrackSizes::CrackSizes(const CrackLines& cracks, const std::vector<Edge>& boundary, double tolerance,
                       const CrackGrading& grading, const std::vector<Point>& panel_ends,
                       std::vector<MouthOnRow> mouths)
    : cracks_(cracks),
      boundary_(boundary),
      edges_(boundary.size() < many_edges ? std::vector<Box>() : coarse_boxes(boundary)),
      tolerance_(tolerance),
      grading_(grading),
      mouths_(std::move(mouths)),
      ends_(panel_ends) {
  for (const Edge& edge : boundary) ends_.push_back(edge.start);
  for (const CrackLine& line : cracks.lines) {
    ways_.push_back({0.0});
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      ways_.back().push_back(ways_.back().back() + segment(line, i).length());
    const double given = given_length(line);
    around_.emplace_back();
    for (const Point& point : line.points) around_.back().extend(point);
    targets_.push_back((given > 0 ? given : line.given_elsewhere) / grading.elements_per_line);
    ends_.insert(ends_.end(), {line.points.front(), line.points.back()});
    for (std::size_t v = 1; v + 1 < line.points.size(); ++v)
      if (turn(line, v) > least_kink) ends_.push_back(line.points[v]);
  }
  for (int l = 0; l < static_cast<int>(cracks.lines.size()); ++l) stations_.push_back(stations_of(l));
}

// Length of elements on segment `i` of line `l` before they are graded (shortened near tips, kinks and gaps). Described
// segments keep their elements when the crack grows.
double CrackSizes::target(int l, std::size_t i) const {
  const CrackLine& line = cracks_.lines[l];
  if (!line.grown[i]) return targets_[l];
  const double length = segment(line, i).length();
  return targets_[l] > 0 ? std::max(targets_[l], length / grading_.elements_per_growth) : length;
}

// Limit that the tips of line `l` set on the element length at the distance `way` along the line. Towards a tip on a
// short segment, elements are no longer than their distance from the tip.
double CrackSizes::from_tips(int l, double way) const {
  const CrackLine& line = cracks_.lines[l];
  const std::vector<double>& ways = ways_[l];
  double limit = infinite;
  if (line.joints[0] < 0) limit = std::max(way, std::min(ways[1], target(l, 0)));
  const std::size_t last = ways.size() - 2;
  if (line.joints[1] < 0)
    limit = std::min(limit, std::max(ways.back() - way, std::min(ways.back() - ways[last], target(l, last))));
  return limit;
}

double CrackSizes::from_kinks(int l, double way) const {
  const CrackLine& line = cracks_.lines[l];
  const std::vector<double>& ways = ways_[l];
  const double halved = std::ldexp(1, -grading_.halvings_at_kinks);
  double limit = infinite;
  const auto consider = [&](double at, double shortest) {
    std::size_t i = 0;
    while (i + 2 < ways.size() && at > ways[i]) ++i;
    const double largest = 2 * std::max(target(l, i), target(l, i > 0 ? i - 1 : 0));
    limit = std::min(limit, std::max(std::abs(way - at), halved * std::min(shortest, largest)));
  };
  for (std::size_t v = 1; v + 1 < ways.size(); ++v)
    if (turn(line, v) > least_kink) consider(ways[v], std::min(ways[v] - ways[v - 1], ways[v + 1] - ways[v]));
  const auto branches = [&](int joint) { return joint >= 0 && !cracks_.joints[joint].mouth; };
  if (branches(line.joints[0])) consider(0, ways[1]);
  if (branches(line.joints[1])) consider(ways.back(), ways.back() - ways[ways.size() - 2]);
  return limit;
}

double CrackSizes::from_rows(const Point& x) const {
  double limit = infinite;
  for (const MouthOnRow& mouth : mouths_)
    limit = std::min(limit, mouth.spacing + growth_from_rows * (x - mouth.place).norm());
  return limit;
}

std::size_t CrackSizes::segment_at(int l, double way) const {
  const std::vector<double>& ways = ways_[l];
  std::size_t own = 0;
  while (own + 2 < ways.size() && way > ways[own + 1]) ++own;
  return own;
}

Point CrackSizes::place_at(int l, double way) const {
  const std::vector<double>& ways = ways_[l];
  const std::size_t own = segment_at(l, way);
  return segment(cracks_.lines[l], own).at((way - ways[own]) / (ways[own + 1] - ways[own]));
}

template <class Visit>
void CrackSizes::for_neighbours(int l, double way, const Point& x, const double& limit, const Visit& visit) const {
  const CrackLine& line = cracks_.lines[l];
  const std::vector<double>& ways = ways_[l];
  const auto to_joint = [&](const auto& is_there) {
    double nearest = infinite;
    for (int end = 0; end < 2; ++end)
      if (line.joints[end] >= 0 && is_there(line.joints[end]))
        nearest = std::min(nearest, end == 0 ? way : ways.back() - way);
    return nearest;
  };
  const auto visit_edge = [&](const Edge& edge) {
    if (least_distance(edge, x) - tolerance_ >= limit) return;
    const double along =
        to_joint([&](int joint) { return bempd::distance(edge, cracks_.joints[joint].place) <= 8 * tolerance_; });
    visit(Neighbour{bempd::distance(edge, x), along, -1});
  };
  if (boundary_.size() < many_edges) {
    for (const Edge& edge : boundary_) visit_edge(edge);
  } else {  // `tolerance_` covers the rounding of boxes
    const Point reach = Point::Constant(std::min(limit, largest_distance) + 2 * tolerance_);
    for (const int edge : edges_.meeting({x - reach, x + reach})) visit_edge(boundary_[static_cast<std::size_t>(edge)]);
  }
  for (int other = 0; other < static_cast<int>(cracks_.lines.size()); ++other) {
    if (other == l) continue;
    const CrackLine& them = cracks_.lines[other];
    const double along = to_joint([&](int joint) { return them.joints[0] == joint || them.joints[1] == joint; });
    visit(Neighbour{distance(them, x), along, other});
  }
  for (std::size_t i = 0; i + 1 < ways.size(); ++i)
    if (way < ways[i] || way > ways[i + 1])
      visit(Neighbour{bempd::distance(segment(line, i), x), std::max(ways[i] - way, way - ways[i + 1]), l});
}

// Limit on the element length at the place x on a crack or edge along a gap of width `gap`. `shortest` is the length of
// the elements at the ends of the gap, `undivided` the limit without the gap.
double CrackSizes::along_gap(double gap, double shortest, double undivided, const Point& x) const {
  if (shortest >= undivided) return shortest;
  double to_end = infinite;
  for (const Point& end : ends_) to_end = std::min(to_end, (end - x).norm());
  const double longer = std::min(longest_along_gap * gap, shortest + growth_along_gap * to_end);
  return std::max(shortest, std::min(undivided, longer));
}

double CrackSizes::on_line(int l, double way) const {
  const CrackLine& line = cracks_.lines[l];
  const bool at_tip = (way == 0 && line.joints[0] < 0) || (way == ways_[l].back() && line.joints[1] < 0);
  const double share = at_tip ? longest_at_tip : longest;
  const Point x = place_at(l, way);
  const double own = target(l, segment_at(l, way));
  // Elements in a small angle between two lines that meet are not made shorter than elements at kinks.
  const double least = std::ldexp(own, -grading_.halvings_at_kinks);
  double limit = std::min({share * from_kinks(l, way), from_tips(l, way), from_rows(x)});
  double widest = limit / share;  // wider gaps do not lower the present limit
  for_neighbours(l, way, x, widest, [&](const Neighbour& near) {
    if (near.distance_along == infinite)
      limit = std::min(limit, along_gap(near.gap, share * near.gap, part_along_crack * own, x));
    else if (near.gap < aside * near.distance_along)
      limit = std::min(limit, std::max(near.gap, least));
    widest = limit / share;
  });
  return limit;
}

NarrowGap CrackSizes::narrowest_gap() const {
  NarrowGap least;
  least.width = infinite;
  for (int l = 0; l < static_cast<int>(cracks_.lines.size()); ++l)
    for (const double way : stations_[l]) {
      const Point x = place_at(l, way);
      for_neighbours(l, way, x, least.width, [&](const Neighbour& near) {
        if (near.distance_along == infinite && near.gap < least.width) least = {l, near.line, near.gap, x};
      });
    }
  return least;
}

std::vector<double> CrackSizes::stations_of(int l) const {
  const std::vector<double>& ways = ways_[l];
  const CrackLine& line = cracks_.lines[l];
  std::vector<double> stations{0.0};
  for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
    const double length = ways[i + 1] - ways[i];
    // A line between two tips has at least two elements, because an element has one tip at most.
    const bool two_tips = ways.size() == 2 && line.joints[0] < 0 && line.joints[1] < 0;
    const int count = std::max(two_tips ? 2 : 1, static_cast<int>(std::ceil(length / target(l, i) * (1 - 1e-9))));
    for (int k = 0; k < count; ++k)
      halve(
          ways[i] + length * k / count, k + 1 == count ? ways[i + 1] : ways[i] + length * (k + 1) / count,
          length / count, [&](double way) { return require_few(stations), on_line(l, way); }, most_halvings, stations);
  }
  return stations;
}

double CrackSizes::on_boundary(const Point& x, double undivided) const {
  // Least length of a boundary element in a small angle between boundary and crack, over the length of the crack
  // element at the mouth.
  const double least = std::ldexp(1, -grading_.halvings_at_kinks);
  double limit = infinite;
  for (std::size_t l = 0; l < cracks_.lines.size(); ++l) {
    const CrackLine& line = cracks_.lines[l];
    const std::vector<double>& stations = stations_[l];
    const double gap = distance(line, x);
    double allowed = along_gap(gap, gap, part_along_boundary * undivided, x);
    for (int end = 0; end < 2; ++end) {
      if (line.joints[end] < 0 || !cracks_.joints[line.joints[end]].mouth) continue;
      const double to_end = (cracks_.joints[line.joints[end]].place - x).norm();
      const double element = end == 0 ? stations[1] : stations.back() - stations[stations.size() - 2];
      const bool beside = to_end > tolerance_ && gap < aside * to_end;  // at the mouth both distances are rounding
      allowed = std::max(allowed, beside ? least * element : std::max(to_end, element));
    }
    limit = std::min(limit, allowed);
  }
  return limit;
}

std::vector<double> CrackSizes::refined(const Arc& piece, const std::vector<double>& stations) const {
  // Elements shorter than their distance from all cracks need no division.
  const Point middle = piece.chord().at(0.5);
  const double reach = piece.length() - least_distance(piece, middle);
  if (std::all_of(around_.begin(), around_.end(), [&](const Box& box) { return box.exteriorDistance(middle) > reach; }))
    return stations;
  std::vector<double> result{stations.front()};
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const double length = (stations[i + 1] - stations[i]) * piece.length();
    halve(
        stations[i], stations[i + 1], length,
        [&](double fraction) { return require_few(result), on_boundary(piece.at(fraction), length); }, most_halvings,
        result);
  }
  return result;
}

}  // namespace bempd::bem

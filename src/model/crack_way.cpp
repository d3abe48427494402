#include "model/crack_way.hpp"

#include <algorithm>
#include <optional>

#include "geometry/segment.hpp"

namespace bempd::model {

namespace {

// A tip that would stop this part of its way before an edge or a crack goes on to it.
constexpr double reach = 1.25;

// Closer to an end of a crack than this part of the way a tip meets that end: what is left beside it would break.
constexpr double near_an_end = 0.1;

// The same for corners of outlines, beside which elements would become tiny.
constexpr double near_a_corner = 1e-3;

class Meetings {
 public:
  Meetings(const Segment& way, double length, double tolerance)
      : way_(way), length_(length), tolerance_(tolerance), behind_tip_(10 * tolerance / way.length()) {}

  void with(const Edge& edge) {
    for (const Crossing& meeting : meeting_points(Edge(way_.start, way_.end), edge)) {
      Point place = way_.at(meeting.fraction_a);
      for (const Point& corner : {edge.start, edge.end})
        if ((corner - place).norm() <= near_a_corner * length_) place = corner;
      consider(meeting.fraction_a, place);
    }
  }

  // With all of a crack but the segment that the tip itself is the end of.
  void with(const scene::Crack& crack, bool own, int own_end) {
    const std::size_t last = crack.points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      if (own && i == (own_end == 0 ? 0 : last - 1)) continue;
      if (const auto crossing = proper_crossing(way_, {crack.points[i], crack.points[i + 1]}))
        consider(crossing->fraction_a, way_.at(crossing->fraction_a));
    }
    for (std::size_t i = 0; i <= last; ++i) {
      if (own && i == (own_end == 0 ? 0 : last)) continue;
      if (distance(way_, crack.points[i]) <= 10 * tolerance_)
        consider(closest_fraction(way_, crack.points[i]), crack.points[i]);
    }
    if (!own || own_end == 1) ends_.push_back(crack.points.front());
    if (!own || own_end == 0) ends_.push_back(crack.points.back());
  }

  // Ends of cracks come last: they take over what is met next to them.
  std::optional<Point> first() {
    for (const Point& end : ends_) {
      const double fraction = closest_fraction(way_, end), close = near_an_end * length_;
      const bool passed = distance(way_, end) <= close && fraction <= first_;
      if (passed || (place_ && (*place_ - end).norm() <= close)) consider(std::min(fraction, first_), end);
    }
    return place_;
  }

 private:
  void consider(double fraction, const Point& place) {
    if (fraction <= behind_tip_ || fraction > first_) return;
    first_ = fraction;
    place_ = place;
  }

  Segment way_;
  double length_, tolerance_, behind_tip_, first_ = 1;
  std::optional<Point> place_;
  std::vector<Point> ends_;
};

}  // namespace

TipWay way_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                  const Point& direction, double length, double tolerance) {
  const std::vector<Point>& own = cracks[static_cast<std::size_t>(crack) - 1].points;
  const Point& from = end == 0 ? own.front() : own.back();
  Meetings meetings({from, from + reach * length * direction}, length, tolerance);
  for (const int region : scene.region_ids())
    for (const Edge& edge : edges_of(scene.region(region).outline())) meetings.with(edge);
  for (std::size_t c = 0; c < cracks.size(); ++c)
    if (!cracks[c].points.empty()) meetings.with(cracks[c], static_cast<int>(c) + 1 == crack, end);
  if (const auto place = meetings.first()) return {*place, true};
  return {from + length * direction, false};
}

void extend(scene::Crack& crack, int end, const Point& to) {
  crack.points.insert(end == 0 ? crack.points.begin() : crack.points.end(), to);
  ++(end == 0 ? crack.grown_at_start : crack.grown_at_end);
}

double length_of(const scene::Crack& crack) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < crack.points.size(); ++i) sum += (crack.points[i + 1] - crack.points[i]).norm();
  return sum;
}

}  // namespace bempd::model

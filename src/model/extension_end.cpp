#include "model/extension_end.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/outline.hpp"
#include "geometry/segment.hpp"

namespace bempd::model {

using crack::TipState;

namespace {

// Search distance ahead of a tip, as a multiple of the extension's length: if an edge or a crack lies within this
// distance, the tip is extended to it.
constexpr double reach = 1.25;

// Distance, as a share of the extension's length, within which a tip that passes the end of a crack joins that end,
// because the ligament between them would break.
constexpr double near_an_end = 0.1;

// Distance, as a share of the extension's length, within which a tip joins a corner of an outline, because elements
// beside the corner would become tiny.
constexpr double near_a_corner = 1e-3;

// Distance, as a share of the extension's length, that a tip keeps from an interface which cracks cannot cross; at most
// half of the tip's present distance from the interface. Elements cannot lie on such an interface either.
constexpr double before_an_interface = 0.25;

// Smallest distance, as a share of the extension's length, between a tip and an interface that its crack crosses.
constexpr double least_distance_from_crossing = 0.25;

// Whether a place lies on an interface of boundary element regions of one material, which cracks can cross.
bool is_among_elements(const scene::Scene& scene, const Point& place, double tolerance) {
  std::vector<int> ids;
  for (const int id : scene.region_ids())
    if (scene::contains(scene, id, place, 10 * tolerance)) ids.push_back(id);
  return ids.size() > 1 && std::all_of(ids.begin(), ids.end(), [&](int id) {
           return scene.region(id).has_elements() && scene.material_of(id) == scene.material_of(ids.front());
         });
}

bool is_inside(const scene::Scene& scene, const Point& place, double tolerance) {
  const std::vector<int> ids = scene.region_ids();
  return std::any_of(ids.begin(), ids.end(), [&](int id) { return scene::has_inside(scene, id, place, tolerance); });
}

// Length of an extension that crosses interfaces at the distances `crossings`: the given length, or a slightly
// different one if the tip would lie too close to an interface.
double length_clear_of_crossings(double length, const std::vector<double>& crossings) {
  const double clear = least_distance_from_crossing * length;
  const auto gap = [&](double way) {
    double least = clear;
    for (const double at : crossings) least = std::min(least, std::abs(at - way));
    return least;
  };
  double best = length;
  for (const double at : crossings)
    for (const double way : {at - clear, at + clear})
      if (std::abs(way - length) <= clear && gap(way) > (1 + 1e-6) * gap(best)) best = way;
  return best;
}

class Meetings {
 public:
  Meetings(const scene::Scene& scene, const Segment& way, double length, double tolerance)
      : scene_(scene), way_(way), length_(length), tolerance_(tolerance), behind_tip_(10 * tolerance / way.length()) {}

  void add_obstacle(const Edge& edge, TipState state) {
    for (const Crossing& meeting : meeting_points(Edge(way_.start, way_.end), edge)) {
      if (goes_on_behind(meeting.fraction_a)) {
        crossings_.push_back(meeting.fraction_a * way_.length());
        continue;
      }
      Point place = way_.at(meeting.fraction_a);
      for (const Point& corner : {edge.start, edge.end})
        if ((corner - place).norm() <= near_a_corner * length_) place = corner;
      consider(meeting.fraction_a, place, state);
    }
  }

  // Adds a crack as an obstacle. If it is the growing crack itself (`own`), the segment that ends at the growing tip
  // `own_end` is left out.
  void add_obstacle(const scene::Crack& crack, bool own, int own_end) {
    const std::size_t last = crack.points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      if (own && i == (own_end == 0 ? 0 : last - 1)) continue;
      if (const auto crossing = proper_crossing(way_, {crack.points[i], crack.points[i + 1]}))
        consider(crossing->fraction_a, way_.at(crossing->fraction_a), TipState::at_crack);
    }
    for (std::size_t i = 0; i <= last; ++i) {
      if (own && i == (own_end == 0 ? 0 : last)) continue;
      if (distance(way_, crack.points[i]) <= 10 * tolerance_)
        consider(closest_fraction(way_, crack.points[i]), crack.points[i], TipState::at_crack);
    }
    if (!own || own_end == 1) ends_.push_back(crack.points.front());
    if (!own || own_end == 0) ends_.push_back(crack.points.back());
  }

  // Distances from the tip to interfaces that the crack crosses, because boundary elements continue behind them.
  const std::vector<double>& crossings() const { return crossings_; }

  // First obstacle on the path, where the extension ends; empty if there is none. Ends of cracks are tested last and
  // replace an obstacle next to them.
  std::optional<ExtensionEnd> first() {
    for (const Point& end : ends_) {
      const double fraction = closest_fraction(way_, end), close = near_an_end * length_;
      const bool passed = distance(way_, end) <= close && fraction <= first_;
      if (passed || (met_ && (met_->to - end).norm() <= close))
        consider(std::min(fraction, first_), end, TipState::at_crack);
    }
    return met_;
  }

 private:
  bool goes_on_behind(double fraction) const {
    if (!is_among_elements(scene_, way_.at(fraction), tolerance_)) return false;
    return is_inside(scene_, way_.at(fraction) + near_a_corner * length_ * way_.direction().normalized(), tolerance_);
  }

  void consider(double fraction, const Point& place, TipState state) {
    if (fraction <= behind_tip_ || fraction > first_) return;
    first_ = fraction;
    met_ = {place, state};
  }

  const scene::Scene& scene_;
  Segment way_;
  double length_, tolerance_, behind_tip_, first_ = 1;
  std::vector<double> crossings_;
  std::optional<ExtensionEnd> met_;
  std::vector<Point> ends_;
};

// Distances from the interface with a lattice, in spacings. A tip with elements that would end closer than
// near_a_lattice to the lattice is extended into it, so that no element becomes much shorter than a spacing. The tip
// then lies into_a_lattice behind the interface, or in the middle of a narrower lattice; lattices narrower than twice
// least_into_a_lattice are not entered. The half spacing in into_a_lattice puts the tip midway between two columns of
// points: for a tip on a column, the error of the load factor of its first growth in the lattice is twice as large.
constexpr double near_a_lattice = 2, into_a_lattice = 4.5, least_into_a_lattice = 1;

// Smallest divisor of into_a_lattice, which is divided by the cosine of the angle between a path and the interface's
// normal.
constexpr double least_cosine_to_border = 1.0 / 3;

// First straight edge, on the path of a tip, of a lattice that has the material of the tip's region.
struct LatticeAhead {
  Point place;
  double way, spacing, width;  // to the edge, between points, and across the lattice along the path [m]
  double cosine;               // cosine of the angle between the path and the edge's normal

  double into() const {
    return std::min(into_a_lattice * spacing / std::max(cosine, least_cosine_to_border), 0.5 * width);
  }
};

std::optional<LatticeAhead> lattice_ahead(const scene::Scene& scene, const Point& from, const Point& direction,
                                          double length, double tolerance) {
  std::optional<LatticeAhead> first;
  const std::vector<int> ids = scene.region_ids();
  const auto own =
      std::find_if(ids.begin(), ids.end(), [&](int id) { return scene::has_inside(scene, id, from, tolerance); });
  if (own == ids.end()) return std::nullopt;
  for (const int id : ids) {
    const scene::Region& region = scene.region(id);
    if (region.has_elements() || scene.material_of(id) != scene.material_of(*own)) continue;
    const double spacing = region.resolution(), farthest = length + near_a_lattice * spacing;
    for (const Edge& edge : edges_of(region.outline())) {
      if (!edge.straight()) continue;
      for (const Crossing& meeting : meeting_points(Edge(from, from + farthest * direction), edge)) {
        const double way = meeting.fraction_a * farthest;
        const Point place = from + way * direction;
        const bool corner = std::min((edge.start - place).norm(), (edge.end - place).norm()) < spacing;
        const double cosine = std::abs(cross(direction, Point(edge.direction().normalized())));
        if (!corner && (!first || way < first->way)) first = LatticeAhead{place, way, spacing, 0, cosine};
      }
    }
    if (!first || first->width > 0) continue;
    first->width = std::numeric_limits<double>::infinity();
    const Point begin = first->place + 0.1 * spacing * direction;
    const double most = 2 * into_a_lattice / least_cosine_to_border * spacing;
    for (const Edge& edge : edges_of(region.outline()))
      for (const Crossing& meeting : meeting_points(Edge(begin, begin + most * direction), edge))
        first->width = std::min(first->width, meeting.fraction_a * most);
  }
  return first;
}

bool is_on_interface(const scene::Scene& scene, const Point& place, double tolerance) {
  int regions = 0;
  for (const int region : scene.region_ids()) regions += scene::contains(scene, region, place, 10 * tolerance) ? 1 : 0;
  return regions > 1;
}

// Distance of a place from an edge, without the parts of the edge that are interfaces which cracks can cross. Infinite
// if cracks can cross all of the edge.
double distance_without_crossable(const scene::Scene& scene, const Edge& edge, const Point& x, double tolerance) {
  const double whole = distance(edge, x);
  std::vector<double> ends{0.0, edge.joint(), 1.0};
  for (const int id : scene.region_ids())
    for (const Edge& other : edges_of(scene.region(id).outline()))
      if (least_distance(edge, other.start) <= 10 * tolerance && distance(edge, other.start) <= 10 * tolerance)
        ends.push_back(closest_fraction(edge, other.start));
  std::sort(ends.begin(), ends.end());
  double least = std::numeric_limits<double>::infinity();
  bool crossable = false;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if ((ends[k + 1] - ends[k]) * edge.length() <= 10 * tolerance) continue;
    if (is_among_elements(scene, edge.at(0.5 * (ends[k] + ends[k + 1])), tolerance)) {
      crossable = true;
    } else {
      least = std::min(least, distance(Edge(edge.part(ends[k], ends[k + 1])), x));
    }
  }
  return crossable ? least : whole;
}

const Point& tip_of(const scene::Crack& crack, int end) {
  return end == 0 ? crack.points.front() : crack.points.back();
}

}  // namespace

ExtensionEnd end_of_extension(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end,
                              const Point& direction, double length, double tolerance) {
  const Point& from = tip_of(cracks[static_cast<std::size_t>(crack) - 1], end);
  Meetings meetings(scene, {from, from + reach * length * direction}, length, tolerance);
  for (const int region : scene.region_ids()) {
    const Outline& outline = scene.region(region).outline();
    const std::size_t outer = outline.loops.front().size();
    const std::vector<Edge> edges = edges_of(outline);
    for (std::size_t k = 0; k < edges.size(); ++k)
      meetings.add_obstacle(edges[k], k < outer ? TipState::at_edge : TipState::at_hole);
  }
  for (std::size_t c = 0; c < cracks.size(); ++c)
    if (!cracks[c].points.empty()) meetings.add_obstacle(cracks[c], static_cast<int>(c) + 1 == crack, end);
  std::optional<ExtensionEnd> met = meetings.first();
  const auto lattice = lattice_ahead(scene, from, direction, reach * length, tolerance);
  if (lattice && lattice->width >= 2 * least_into_a_lattice * lattice->spacing &&
      (!met || lattice->way <= (met->to - from).norm() + tolerance))
    return {from + (lattice->way + lattice->into()) * direction, TipState::grows};
  if (!met) return {from + length_clear_of_crossings(length, meetings.crossings()) * direction, TipState::grows};
  if (met->state == TipState::at_crack || !is_on_interface(scene, met->to, tolerance)) return *met;
  const double way = (met->to - from).norm(), left = std::min(before_an_interface * length, 0.5 * way);
  return {from + (1 - left / way) * (met->to - from), TipState::at_interface};
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

double clearance_of_tip(const scene::Scene& scene, const std::vector<scene::Crack>& cracks, int crack, int end) {
  const double tolerance = geometric_tolerance(scene.bounding_box());
  const Point& tip = tip_of(cracks[static_cast<std::size_t>(crack) - 1], end);
  std::vector<std::pair<double, Edge>> nearest_first;  // with a lower bound on the distance of each edge
  for (const int region : scene.region_ids())
    for (const Edge& edge : edges_of(scene.region(region).outline()))
      nearest_first.emplace_back(least_distance(edge, tip), edge);
  std::sort(nearest_first.begin(), nearest_first.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [bound, edge] : nearest_first) {
    if (bound > least + tolerance) break;
    least = std::min(least, distance_without_crossable(scene, edge, tip, tolerance));
  }
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    if (static_cast<int>(c) + 1 != crack) least = std::min(least, polyline_distance(cracks[c].points, tip));
  }
  return least;
}

}  // namespace bempd::model

#include "regions/crack_parts.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"
#include "error.hpp"
#include "regions/crack_crossings.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

using scene::Scene;

namespace {

// Fractions of a segment, ascending, at which it may pass from one region to another: the segment's ends, its crossings
// with edges of outlines, and vertices of outlines that lie on the segment.
std::vector<double> stations_on(const Scene& scene, const Segment& segment, double tolerance) {
  std::vector<double> fractions{0.0, 1.0};
  for (int id : scene.region_ids()) {
    for (const Edge& edge : edges_of(scene.region(id).outline())) {
      if (least_distance(edge, segment.at(0.5)) > 0.5 * segment.length() + 2 * tolerance) continue;
      for (const Crossing& crossing : meeting_points(Edge(segment.start, segment.end), edge))
        fractions.push_back(crossing.fraction_a);
      if (distance(segment, edge.start) <= tolerance) fractions.push_back(closest_fraction(segment, edge.start));
    }
  }
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

// Region for the piece of a crack around the point `middle`: 0 if the point lies in a lattice, whose bonds are cut,
// else the id of the region that has elements on the crack. Throws Error (argument) outside the body and on interfaces.
int region_of_piece(const Preparation& p, int crack, const Point& middle) {
  std::vector<int> with_elements;
  int other = 0;
  for (const auto& region : p.regions) {
    if (!scene::contains(p.scene, region->id(), middle, p.tolerance)) continue;
    if (region->bonds()) return 0;
    if (region->crack_elements()) with_elements.push_back(region->id());
    other = region->id();
  }
  require(other > 0, "crack ", crack, " passes (", middle.x(), ", ", middle.y(),
          "), which is outside the body; end the crack on the body's boundary or inside");
  require(!with_elements.empty(), "crack ", crack, " passes (", middle.x(), ", ", middle.y(), "), which is in region ",
          other, ", a ", p.scene.region(other).adjective(),
          " region; the chosen scheme has cracks in peridynamic regions only, scheme symmetric has them in both");
  require(with_elements.size() == 1, "crack ", crack, " runs along the interface of the regions ",
          with_elements.front(), " and ", with_elements.back(), " at (", middle.x(), ", ", middle.y(),
          "); it has to lie inside of one of them");
  return with_elements.front();
}

// Crossings of a crack with interfaces: places where the crack passes from one boundary element region to another, or
// between a boundary element region and lattices. `first_region` becomes the region of the crack's first piece
// (region_of_piece()).
std::vector<CrackCrossing> crossings_of(const Preparation& p, int crack, const std::vector<Point>& points,
                                        int& first_region) {
  std::vector<CrackCrossing> found;
  int present = -1;
  double way = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    check_cancelled();
    const Segment segment{points[k], points[k + 1]};
    const std::vector<double> stations = stations_on(p.scene, segment, p.tolerance);
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      if ((stations[i + 1] - stations[i]) * segment.length() <= 10 * p.tolerance) continue;
      const int region = region_of_piece(p, crack, segment.at(0.5 * (stations[i] + stations[i + 1])));
      if (present < 0) {
        first_region = region;
      } else if (region != present) {
        found.push_back({way + stations[i] * segment.length(), segment.at(stations[i]),
                         segment.direction().normalized(), present, region});
      }
      present = region;
    }
    way += segment.length();
  }
  // All pieces of the crack are too short to be examined above, so the middle of its first segment decides.
  if (present < 0) first_region = region_of_piece(p, crack, 0.5 * (points[0] + points[1]));
  return found;
}

// Smallest angle between two segments that counts as a bend [rad]. Smaller turns occur in polygons that stand for a
// curve.
constexpr double smallest_bend_angle = 0.2;

// Distance along a polyline from the vertex `from`, forwards or backwards, to its next bend or its end.
double way_to_bend(const std::vector<Point>& points, std::size_t from, bool forwards) {
  std::vector<Point> ahead(points.begin() + static_cast<std::ptrdiff_t>(forwards ? from : 0),
                           forwards ? points.end() : points.begin() + static_cast<std::ptrdiff_t>(from) + 1);
  if (!forwards) std::reverse(ahead.begin(), ahead.end());
  double way = 0;
  for (std::size_t i = 0; i + 1 < ahead.size(); ++i) {
    const Point along = ahead[i + 1] - ahead[i];
    if (i > 0) {
      const Point before = ahead[i] - ahead[i - 1];
      if (std::abs(std::atan2(cross(before, along), before.dot(along))) > smallest_bend_angle) break;
    }
    way += along.norm();
  }
  return way;
}

// Parts of the crack in the scene before growth, if the crack has not grown since and has one part; else null.
const PartedCrack* unchanged_before(const Preparation& p, int id, const scene::Crack& crack) {
  if (!p.cracks_before || static_cast<std::size_t>(id) > p.cracks_before->size()) return nullptr;
  const PartedCrack& before = (*p.cracks_before)[static_cast<std::size_t>(id) - 1];
  return before.parts.size() == 1 && before.crack == crack ? &before : nullptr;
}

PartedCrack parted(const Preparation& p, int id, const scene::Crack& crack, std::vector<std::string>& warnings) {
  if (crack.points.empty()) return {};
  if (const PartedCrack* same = unchanged_before(p, id, crack)) return *same;
  int region = 0;
  std::vector<CrackCrossing> crossings = crossings_of(p, id, crack.points, region);
  if (crossings.empty()) return {crack, {{region, crack.points, crack.grown_at_start, crack.grown_at_end}}};
  move_between_rows(p, id, crossings, polyline_length(crack.points), warnings);
  const MovedCrack bent = bent_to(crack, crossings, 10 * p.tolerance);
  PartedCrack result{bent.crack(), {}};
  std::size_t from = 0;
  double start = 0;
  for (std::size_t k = 0; k <= crossings.size(); ++k) {
    const bool last = k == crossings.size();
    const std::size_t to = last ? bent.points.size() - 1 : bent.crossings[k];
    CrackPart part{region,
                   {bent.points.begin() + static_cast<std::ptrdiff_t>(from),
                    bent.points.begin() + static_cast<std::ptrdiff_t>(to) + 1}};
    const auto [at_start, at_end] = bent.grown_at_ends(from, to);
    part.grown_at_start = at_start, part.grown_at_end = at_end;
    part.start = start, part.from_another = k > 0, part.into_another = !last;
    if (k > 0) part.spacing_before = crossings[k - 1].spacing;
    if (!last) part.spacing_behind = crossings[k].spacing;
    if (k > 0 && crossings[k - 1].among_elements()) part.reach_before = way_to_bend(bent.points, from, false);
    if (!last && crossings[k].among_elements()) part.reach_behind = way_to_bend(bent.points, to, true);
    start += polyline_length(part.points);
    result.parts.push_back(std::move(part));
    from = to;
    if (!last) region = crossings[k].after;
  }
  return result;
}

}  // namespace

bool PartedCrack::has_elements() const {
  return std::any_of(parts.begin(), parts.end(), [](const CrackPart& part) { return part.region > 0; });
}

bool PartedCrack::has_elements_in(int region) const {
  return std::any_of(parts.begin(), parts.end(), [&](const CrackPart& part) { return part.region == region; });
}

const CrackPart& PartedCrack::part_at(double fraction) const {
  const double way = fraction * polyline_length(crack.points);
  const CrackPart* found = &parts.front();
  for (const CrackPart& part : parts)
    if (way > part.start || (way == part.start && part.region > 0)) found = &part;
  return *found;
}

std::vector<PartedCrack> parted_cracks(const Preparation& preparation, std::vector<std::string>& warnings) {
  std::vector<PartedCrack> cracks;
  for (const scene::Crack& crack : preparation.scene.cracks())
    cracks.push_back(parted(preparation, static_cast<int>(cracks.size()) + 1, crack, warnings));
  require_mouths_apart(cracks, preparation.tolerance);
  return cracks;
}

}  // namespace bempd::regions

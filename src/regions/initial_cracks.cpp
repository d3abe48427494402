#include "regions/initial_cracks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::regions {

using scene::Scene;

namespace {

// Where a segment may pass from one region to another: crossings with edges, and vertices and ends that touch.
std::vector<double> crossings(const Scene& scene, const Segment& segment, double tolerance) {
  std::vector<double> fractions{0.0, 1.0};
  for (int id : scene.region_ids()) {
    for (const Edge& edge : edges_of(scene.region(id).outline())) {
      for (const Crossing& crossing : meeting_points(Edge(segment.start, segment.end), edge))
        fractions.push_back(crossing.fraction_a);
      if (distance(segment, edge.start) <= tolerance) fractions.push_back(closest_fraction(segment, edge.start));
    }
  }
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

// The region that has elements on a piece of a crack, 0 where bonds can be cut.
int region_of_piece(const Preparation& p, int crack, const Point& middle) {
  std::vector<int> with_elements;
  int other = 0;
  for (const auto& region : p.regions) {
    if (locate(p.scene.region(region->id()).outline(), middle, p.tolerance) == Location::outside) continue;
    if (region->takes_cracks()) return 0;
    if (region->has_crack_elements()) with_elements.push_back(region->id());
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

int region_of_crack(const Preparation& p, int crack, const std::vector<Point>& points) {
  if (points.empty()) return 0;  // removed
  int found = -1;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    check_cancelled();
    const Segment segment{points[k], points[k + 1]};
    const std::vector<double> stations = crossings(p.scene, segment, p.tolerance);
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      if ((stations[i + 1] - stations[i]) * segment.length() <= 10 * p.tolerance) continue;
      const Point middle = segment.at(0.5 * (stations[i] + stations[i + 1]));
      const int region = region_of_piece(p, crack, middle);
      const auto name = [&](int id) {
        return id == 0 ? std::string("a peridynamic region") : text("the BEM region ", id);
      };
      require(found < 0 || region == found, "crack ", crack, " goes from ", name(found), " into ", name(region),
              " before (", middle.x(), ", ", middle.y(), "); end it at the interface");
      found = region;
    }
  }
  // All of it may be too short for the question where it passes from one region to another.
  return found < 0 ? region_of_piece(p, crack, 0.5 * (points[0] + points[1])) : found;
}

// How far a crack passes material points by, in spacings: next to nothing, as any place between the same rows cuts the
// same bonds.
constexpr double aside = 1e-3;
constexpr int ways_aside = 8;

// A crack moved to its right, or turned from there by an angle; a mouth reaches a little farther, so that it stays one.
scene::Crack moved(const Scene& scene, const Discretization& d, scene::Crack crack, double distance, double angle) {
  std::vector<Point>& points = crack.points;
  const Point first = (points[1] - points[0]).normalized(), last = (points.end()[-1] - points.end()[-2]).normalized();
  const auto farther = [&](const Point& end) {
    const bool is_inside = std::any_of(d.regions.begin(), d.regions.end(), [&](const auto& region) {
      return locate(scene.region(region->id()).outline(), end, d.tolerance) == Location::inside;
    });
    return is_inside ? 0 : 2 * distance;
  };
  const double at_start = farther(points.front()), at_end = farther(points.back());
  const Point shift = distance * (Eigen::Rotation2Dd(angle) * Point(first.y(), -first.x()));
  for (Point& p : points) p += shift;
  points.front() -= at_start * first, points.back() += at_end * last;
  return crack;
}

std::vector<Point> points_met(const scene::Crack& crack, const Discretization& d) {
  std::vector<Point> met;
  for (const auto& region : d.regions) {
    const std::vector<Point> some = region->points_met_by(crack);
    met.insert(met.end(), some.begin(), some.end());
  }
  return met;
}

// Whether a crack runs along a boundary behind which there is no lattice: it has no other side there.
bool runs_along_boundary(const Scene& scene, const scene::Crack& crack, const Discretization& d,
                         const std::vector<Point>& met) {
  return std::any_of(met.begin(), met.end(), [&](const Point& p) {
    const auto near_end = [&](const Point& end) { return (p - end).norm() <= 10 * d.tolerance; };
    if (near_end(crack.points.front()) || near_end(crack.points.back())) return false;
    int inside = 0, beside = 0;
    for (const auto& region : d.regions) {
      if (!region->takes_cracks()) continue;
      const Location at = locate(scene.region(region->id()).outline(), p, d.tolerance);
      inside += at == Location::inside, beside += at == Location::on_boundary;
    }
    return inside == 0 && beside < 2;
  });
}

// Of the first way aside by which it meets no point; as it was if there is none.
void pass_points_by(const Scene& scene, const Discretization& d, int number, LatticeCracks& found) {
  scene::Crack& crack = found.cracks[static_cast<std::size_t>(number) - 1];
  const std::vector<Point> met = points_met(crack, d);
  if (met.empty() || runs_along_boundary(scene, crack, d, met)) return;
  double spacing = std::numeric_limits<double>::infinity();
  for (const auto& region : d.regions)
    if (const std::optional<LatticeGrid> grid = region->lattice_grid()) spacing = std::min(spacing, grid->spacing);
  if (std::isinf(spacing)) return;  // scheme paper
  for (int way = 0; way < ways_aside; ++way) {
    // To the right, to the left, and between.
    const double angle = way < 2 ? way * std::numbers::pi : way * std::numbers::phi;
    const scene::Crack beside = moved(scene, d, crack, aside * spacing, angle);
    if (!points_met(beside, d).empty()) continue;
    crack = beside;
    found.warnings.push_back(text("crack ", number, " passes through ", met.size(), " material points, the first at (",
                                  met.front().x(), ", ", met.front().y(), "); it passes them by on its ",
                                  way == 0 ? "right" : "left", ", where its faces lie up to half a spacing beside it"));
    return;
  }
}

}  // namespace

std::vector<int> regions_of_cracks(const Preparation& preparation) {
  std::vector<int> regions;
  for (const scene::Crack& crack : preparation.scene.cracks())
    regions.push_back(region_of_crack(preparation, static_cast<int>(regions.size()) + 1, crack.points));
  return regions;
}

LatticeCracks cracks_in_lattices(const Scene& scene, const Discretization& d, const scene::Options& options) {
  LatticeCracks found{scene.cracks(), {}, {}};
  for (std::size_t c = 0; c < found.cracks.size(); ++c)
    if (d.crack_regions[c] == 0 && found.cracks[c].points.size() > 1)
      pass_points_by(scene, d, static_cast<int>(c) + 1, found);
  if (options.text_value("pd.crack_tip") == "ahead") return found;
  for (std::size_t c = 0; c < found.cracks.size(); ++c) {
    const std::vector<Point> points = found.cracks[c].points;
    if (d.crack_regions[c] > 0 || points.size() < 2) continue;
    const auto move = [&](const Point& tip, const Point& before, Point& end) {
      // Both ends of a single piece may move.
      const double length = (tip - before).norm(), backward = (points.size() > 2 ? 0.9 : 0.45) * length;
      for (const auto& region : d.regions) {
        if (locate(scene.region(region->id()).outline(), tip, d.tolerance) != Location::inside) continue;
        const pd::FeltEnd felt = region->end_felt_at(tip, (tip - before) / length, backward);
        end = felt.end;
        for (const int bond : felt.weakened) found.weakened.emplace_back(bond, felt.share);
      }
    };
    move(points.front(), points[1], found.cracks[c].points.front());
    move(points.back(), points.end()[-2], found.cracks[c].points.back());
  }
  return found;
}

std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& d,
                                     std::vector<std::string>& warnings) {
  std::vector<int> cut;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    if (d.crack_regions[c] > 0) continue;
    const int id = static_cast<int>(c) + 1;
    for (const auto& region : d.regions) region->cut(cracks[c], id, cut, warnings);
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

std::vector<StartingTip> tips_of_cracks(const Scene& scene, const std::vector<scene::Crack>& cracks,
                                        const Discretization& d, const scene::Options& options) {
  std::vector<StartingTip> tips;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const std::vector<Point>& points = cracks[c].points;
    if (d.crack_regions[c] > 0 || points.size() < 2) continue;
    for (const int number : {0, 1}) {
      const Point& end = number == 0 ? points.front() : points.back();
      const Point& before = number == 0 ? points[1] : points.end()[-2];
      for (const auto& region : d.regions) {
        if (locate(scene.region(region->id()).outline(), end, d.tolerance) != Location::inside) continue;
        if (region->tip_law(options))
          tips.push_back({end, (end - before).normalized(), region->id(), {static_cast<int>(c) + 1, number}});
      }
    }
  }
  return tips;
}

}  // namespace bempd::regions

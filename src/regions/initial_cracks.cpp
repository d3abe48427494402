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

// Distance in spacings by which a crack that would pass through material points is shifted aside. It is very small,
// because any place between the same two rows cuts the same bonds. Then the number of directions tried.
constexpr double aside = 1e-3;
constexpr int ways_aside = 8;

// Distance in spacings from another lattice below which bonds of both lattices act on a tip.
constexpr double beside_lattice = 1.5;

// Copy of a crack shifted by `distance` to the right of its first segment, or in the direction at `angle` from there,
// counter-clockwise. An end on the boundary or outside is also lengthened, so that it stays a mouth.
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
    const std::vector<Point> some = region->points_on_crack(crack);
    met.insert(met.end(), some.begin(), some.end());
  }
  return met;
}

// Whether a crack runs along a boundary without a lattice on the other side, where it has no second face. `met` are the
// material points on the crack.
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

// Shifts a crack that meets material points aside, in the first direction in which it meets none, and warns of that. It
// stays in place if there is no such direction.
void shift_off_points(const Scene& scene, const Discretization& d, int number, LatticeCracks& found) {
  scene::Crack& crack = found.cracks[static_cast<std::size_t>(number) - 1];
  const std::vector<Point> met = points_met(crack, d);
  if (met.empty() || runs_along_boundary(scene, crack, d, met)) return;
  double spacing = std::numeric_limits<double>::infinity();
  for (const auto& region : d.regions)
    if (const std::optional<LatticeGrid> grid = region->lattice_grid()) spacing = std::min(spacing, grid->spacing);
  if (std::isinf(spacing)) return;  // scheme paper
  for (int way = 0; way < ways_aside; ++way) {
    // Order of directions: to the right, to the left, then others between these.
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

// Whether the initial crack at `tip` is cut so that its effective tip lies where the host described it (option
// pd.crack_tip = stated, or auto). With auto not beside another lattice, because bonds of both lattices determine the
// tip there.
bool ends_as_stated(const Scene& scene, const Discretization& d, const scene::Options& options, const Region& region,
                    const Point& tip) {
  const std::string choice = options.text_value("pd.crack_tip");
  if (choice != "auto") return choice == "stated";
  const std::optional<LatticeGrid> grid = region.lattice_grid();
  if (!grid || options.text_in_effect("crack.rule") == "bond") return false;
  return std::none_of(d.regions.begin(), d.regions.end(), [&](const auto& other) {
    if (other->id() == region.id() || !other->lattice_grid()) return false;
    const std::vector<Edge> edges = edges_of(scene.region(other->id()).outline());
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Edge& edge) { return distance(edge, tip) < beside_lattice * grid->spacing; });
  });
}

}  // namespace

LatticeCracks cracks_in_lattices(const Scene& scene, const Discretization& d, const scene::Options& options) {
  LatticeCracks found;
  for (const PartedCrack& parted : d.cracks) found.cracks.push_back(parted.crack);
  for (std::size_t c = 0; c < found.cracks.size(); ++c)
    if (d.cracks[c].cuts_bonds() && found.cracks[c].points.size() > 1)
      shift_off_points(scene, d, static_cast<int>(c) + 1, found);
  for (std::size_t c = 0; c < found.cracks.size(); ++c) {
    const std::vector<Point> points = found.cracks[c].points;
    if (!d.cracks[c].cuts_bonds() || points.size() < 2) continue;
    const auto move = [&](const Point& tip, const Point& before, Point& end) {
      // A crack of one segment may have two tips, so the cut at each tip may be shortened by less than half of it.
      const double length = (tip - before).norm(), backward = (points.size() > 2 ? 0.9 : 0.45) * length;
      for (const auto& region : d.regions) {
        if (locate(scene.region(region->id()).outline(), tip, d.tolerance) != Location::inside) continue;
        if (!ends_as_stated(scene, d, options, *region, tip)) continue;
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
    if (!d.cracks[c].cuts_bonds()) continue;
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
    if (!d.cracks[c].cuts_bonds() || points.size() < 2) continue;
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

#include "regions/initial_cracks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "cancellation.hpp"
#include "error.hpp"
#include "pd/crack.hpp"

namespace bempd::regions {

using scene::Scene;

namespace {

// Distance by which a crack that would pass through material points is shifted [spacings]. It is very small, because at
// any place between the same two rows the crack cuts the same bonds.
constexpr double crack_shift = 1e-3;

// Number of directions that are tried for the shift of a crack beside material points.
constexpr int shift_directions = 8;

// Distance of a tip from another lattice, in spacings, below which bonds of both lattices act on the tip.
constexpr double beside_lattice = 1.5;

// Copy of a crack that is shifted by `distance`. The shift is turned by `angle`, counter-clockwise, from the direction
// to the right of the crack's first segment. An end on the boundary or outside of the body is also lengthened, so that
// it stays a mouth.
scene::Crack moved(const Scene& scene, const Discretization& d, scene::Crack crack, double distance, double angle) {
  std::vector<Point>& points = crack.points;
  const Point first = (points[1] - points[0]).normalized(), last = (points.end()[-1] - points.end()[-2]).normalized();
  const auto farther = [&](const Point& end) {
    const bool is_inside = std::any_of(d.regions.begin(), d.regions.end(), [&](const auto& region) {
      return scene::has_inside(scene, region->id(), end, d.tolerance);
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
    if (!region->bonds()) continue;
    const std::vector<Point> some = region->bonds()->points_on_crack(crack);
    met.insert(met.end(), some.begin(), some.end());
  }
  return met;
}

// Whether a crack runs along a boundary with no lattice on the other side, where the crack has no second face. `met`
// are the material points on the crack.
bool runs_along_boundary(const Scene& scene, const scene::Crack& crack, const Discretization& d,
                         const std::vector<Point>& met) {
  return std::any_of(met.begin(), met.end(), [&](const Point& p) {
    const auto near_end = [&](const Point& end) { return (p - end).norm() <= 10 * d.tolerance; };
    if (near_end(crack.points.front()) || near_end(crack.points.back())) return false;
    int inside = 0, beside = 0;
    for (const auto& region : d.regions) {
      if (!region->bonds()) continue;
      const Location at = locate(scene.region(region->id()).outline(), p, d.tolerance);
      inside += at == Location::inside, beside += at == Location::on_boundary;
    }
    return inside == 0 && beside < 2;
  });
}

// Shifts a crack that passes through material points, in the first direction in which the shifted crack meets none, and
// adds a warning. The crack stays in place if there is no such direction.
void shift_off_points(const Scene& scene, const Discretization& d, int number, LatticeCracks& found) {
  scene::Crack& crack = found.cracks[static_cast<std::size_t>(number) - 1];
  const std::vector<Point> met = points_met(crack, d);
  if (met.empty() || runs_along_boundary(scene, crack, d, met)) return;
  double spacing = std::numeric_limits<double>::infinity();
  for (const auto& region : d.regions)
    if (const std::optional<LatticeGrid> grid = region->lattice_grid()) spacing = std::min(spacing, grid->spacing);
  if (std::isinf(spacing)) return;  // as in the scheme paper
  for (int direction = 0; direction < shift_directions; ++direction) {
    // The crack is shifted to its right first, then to its left, then in other directions.
    const double angle = direction < 2 ? direction * std::numbers::pi : direction * std::numbers::phi;
    const scene::Crack beside = moved(scene, d, crack, crack_shift * spacing, angle);
    if (!points_met(beside, d).empty()) continue;
    crack = beside;
    found.warnings.push_back(text("crack ", number, " passes through ", met.size(), " material points, the first at (",
                                  met.front().x(), ", ", met.front().y(), "); it passes them by on its ",
                                  direction == 0 ? "right" : "left",
                                  ", where its faces lie up to half a spacing beside it"));
    return;
  }
}

bool are_alike(const Region& one, const Region& other) {
  const std::optional<LatticeGrid> a = one.lattice_grid(), b = other.lattice_grid();
  return a && b && a->spacing == b->spacing && a->horizon == b->horizon && a->angle == b->angle &&
         one.elasticity() == other.elasticity();
}

// Whether the cut of an initial crack is placed so that the crack's effective tip lies at `tip`, where the host
// described it. This is done for cracks that grow as lines, except near a lattice of another kind, where bonds of both
// lattices determine the effective tip.
bool has_effective_tip_as_described(const Scene& scene, const Discretization& d, const scene::Options& options,
                                    const Region& region, const Point& tip) {
  const std::optional<LatticeGrid> grid = region.lattice_grid();
  if (!grid || options.text_in_effect("crack.rule") == "bond") return false;
  return std::none_of(d.regions.begin(), d.regions.end(), [&](const auto& other) {
    if (!other->lattice_grid() || are_alike(region, *other)) return false;
    const std::vector<Edge> edges = edges_of(scene.region(other->id()).outline());
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Edge& edge) { return distance(edge, tip) < beside_lattice * grid->spacing; });
  });
}

// End of the cut that puts the effective tip of a crack at `tip`, computed from the bonds of the region and of the
// regions that continue its lattice. The cut ends at most `backward` [m] behind the tip.
pd::CutEnd cut_end_in_lattice(const Discretization& d, const Region& region, const Point& tip, const Point& direction,
                              double backward) {
  const LatticeGrid grid = *region.lattice_grid();
  const int horizon_ratio = static_cast<int>(std::lround(grid.horizon / grid.spacing));
  std::vector<int> point_of(d.positions.size(), -1);
  std::vector<Point> points;
  for (const auto& other : d.regions)
    if (are_alike(region, *other))
      for (const int node : other->nodes()) {
        const Point place = (d.positions[static_cast<std::size_t>(node)] - tip) / grid.spacing;
        int& number = point_of[static_cast<std::size_t>(node)];
        if (number >= 0 || place.norm() > 5 * horizon_ratio) continue;
        number = static_cast<int>(points.size());
        points.push_back(place);
      }
  std::vector<pd::Bond> bonds;
  std::vector<int> term_of;
  for (std::size_t t = 0; t < d.bonds.size(); ++t) {
    if (d.bonds.is_wide(t)) continue;
    const int first = point_of[static_cast<std::size_t>(d.bonds.first[t])],
              second = point_of[static_cast<std::size_t>(d.bonds.second[t])];
    if (first < 0 || second < 0) continue;
    bonds.push_back({first, second, d.bonds.stiffness[t]}), term_of.push_back(static_cast<int>(t));
  }
  pd::CutEnd found = pd::cut_end_for_tip(points, bonds, Point(0, 0), direction, horizon_ratio, backward / grid.spacing);
  found.end = tip + grid.spacing * found.end;
  if (found.even_ahead) *found.even_ahead *= grid.spacing;
  for (int& bond : found.weakened) bond = term_of[static_cast<std::size_t>(bond)];
  return found;
}

// End of the cut through bonds for a crack's tip, with the bonds that are weakened there. If the effective tip cannot
// be placed at `tip`, the cut ends at `tip`. `before` is the crack's point before `tip`, and `part` the largest share
// of the last segment by which the cut may be shortened.
pd::CutEnd end_of_cut(const Scene& scene, const Discretization& d, const scene::Options& options, const Point& tip,
                      const Point& before, double part) {
  const double length = (tip - before).norm();
  for (const auto& region : d.regions)
    if (scene::has_inside(scene, region->id(), tip, d.tolerance) &&
        has_effective_tip_as_described(scene, d, options, *region, tip))
      return cut_end_in_lattice(d, *region, tip, (tip - before) / length, part * length);
  return {tip, {}};
}

// Places the two ends of the cut that a crack, as the host described it, makes through bonds. Pieces that growth has
// added cut bonds where they lie.
void place_ends(const Scene& scene, const Discretization& d, const scene::Options& options, int number,
                LatticeCracks& found) {
  const auto c = static_cast<std::size_t>(number) - 1;
  scene::Crack& crack = found.cracks[c];
  const std::span<const Point> given = crack.given();
  if (given.empty()) return;
  found.ends[c] = {given.front(), given.back()};
  if (!d.cracks[c].cuts_bonds() || given.size() < 2) return;
  // A crack of one segment may have two tips, so the cut at each tip may be shortened by less than half of the segment.
  const double part = given.size() > 2 ? 0.9 : 0.45;
  const std::array placed{end_of_cut(scene, d, options, given.front(), given[1], part),
                          end_of_cut(scene, d, options, given.back(), given.end()[-2], part)};
  crack.points[static_cast<std::size_t>(crack.grown_at_start)] = placed[0].end;
  crack.points.end()[-1 - crack.grown_at_end] = placed[1].end;
  found.even_ahead[c] = {placed[0].even_ahead, placed[1].even_ahead};
  for (const pd::CutEnd& end : placed)
    for (const int bond : end.weakened) found.weakened.push_back({bond, end.share, number});
}

}  // namespace

LatticeCracks cracks_in_lattices(const Scene& scene, const Discretization& d, const scene::Options& options) {
  LatticeCracks found;
  for (const PartedCrack& parted : d.cracks) found.cracks.push_back(parted.crack);
  found.ends.resize(found.cracks.size()), found.even_ahead.resize(found.cracks.size());
  for (std::size_t c = 0; c < found.cracks.size(); ++c)
    if (d.cracks[c].cuts_bonds() && found.cracks[c].points.size() > 1)
      shift_off_points(scene, d, static_cast<int>(c) + 1, found);
  for (std::size_t c = 0; c < found.cracks.size(); ++c) place_ends(scene, d, options, static_cast<int>(c) + 1, found);
  return found;
}

std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& d,
                                     std::vector<std::string>& warnings) {
  std::vector<int> cut;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    if (!d.cracks[c].cuts_bonds()) continue;
    const int id = static_cast<int>(c) + 1;
    for (const auto& region : d.regions)
      if (const RegionBonds* bonds = region->bonds()) bonds->cut(cracks[c], id, cut, warnings);
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

std::vector<StartingTip> tips_of_cracks(const Scene& scene, const LatticeCracks& found, const Discretization& d,
                                        const scene::Options& options) {
  std::vector<StartingTip> tips;
  for (std::size_t c = 0; c < found.cracks.size(); ++c) {
    const scene::Crack& crack = found.cracks[c];
    const std::vector<Point>& points = crack.points;
    if (!d.cracks[c].cuts_bonds() || points.size() < 2) continue;
    for (const int number : {0, 1}) {
      const bool has_grown = (number == 0 ? crack.grown_at_start : crack.grown_at_end) > 0;
      const std::optional<double> even =
          has_grown ? std::nullopt : found.even_ahead[c][static_cast<std::size_t>(number)];
      const Point& end = number == 0 ? points.front() : points.back();
      const Point& before = number == 0 ? points[1] : points.end()[-2];
      // The effective tip may lie in another region than the end of the cut. The tip then grows by the rules of the
      // region of the effective tip.
      const Point& acts_at = even ? found.ends[c][static_cast<std::size_t>(number)] : end;
      for (const auto& region : d.regions) {
        if (!scene::has_inside(scene, region->id(), acts_at, d.tolerance)) continue;
        if (region->bonds() && region->bonds()->tip_law(options))
          tips.push_back({end, (end - before).normalized(), region->id(), {static_cast<int>(c) + 1, number}, even});
      }
    }
  }
  return tips;
}

// Lengths of the cracks between their described ends, and the distances from these ends to the ends of the cuts. A
// piece that growth has added begins where the cut ends, not at the effective tip.
std::vector<pd::CrackLength> lengths_of(const LatticeCracks& found) {
  std::vector<pd::CrackLength> lengths;
  for (std::size_t c = 0; c < found.cracks.size(); ++c) {
    const scene::Crack& crack = found.cracks[c];
    const std::vector<Point>& points = crack.points;
    pd::CrackLength& length = lengths.emplace_back();
    for (std::size_t k = 1; k < points.size(); ++k) length.length += (points[k] - points[k - 1]).norm();
    if (points.size() < 2) continue;
    const auto to_cut = [&](const Point& cut, const Point& before, const Point& felt) {
      return (cut - before).norm() - (felt - before).norm();
    };
    if (crack.grown_at_start == 0) length.to_cut[0] = to_cut(points.front(), points[1], found.ends[c][0]);
    if (crack.grown_at_end == 0) length.to_cut[1] = to_cut(points.back(), points.end()[-2], found.ends[c][1]);
    length.length -= length.to_cut[0] + length.to_cut[1];
  }
  return lengths;
}

}  // namespace bempd::regions

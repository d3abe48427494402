#include "regions/tips/tip_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "geometry/segment.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::regions {

namespace {

using Cell = std::pair<int, int>;

// Middles of the broken bonds between nearest neighbours of a lattice, and broken cells: both cells beside such a bond,
// unless an initial crack cuts the bond.
class BrokenFaces {
 public:
  BrokenFaces(const BondedBody& body, const LatticeGrid& grid) : grid_(grid), turn_(Eigen::Rotation2Dd(grid.angle)) {
    const std::vector<Point>& positions = body.discretization.positions;
    std::vector<char> is_cut(body.bonds.size(), 0);
    for (const int bond : body.cut) is_cut[bond] = 1;
    for (std::size_t b = 0; b < body.bonds.size(); ++b) {
      if (body.intact[b] || body.bonds.is_wide(b)) continue;
      if (std::abs(body.bonds.length[b] - grid.spacing) > 0.01 * grid.spacing) continue;
      const Point middle = 0.5 * (positions[body.bonds.first[b]] + positions[body.bonds.second[b]]);
      middles_.push_back(middle);
      if (is_cut[b]) continue;
      const Point across = 0.5 * grid.spacing * Point(-body.bonds.sine[b], body.bonds.cosine[b]);
      broken_.insert(cell_at(middle + across)), broken_.insert(cell_at(middle - across));
    }
  }

  const std::vector<Point>& middles() const { return middles_; }
  Cell cell_at(const Point& p) const {
    const Point at = turn_.transpose() * (p - grid_.origin) / grid_.spacing;
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }
  Point middle_of(const Cell& cell) const {
    return grid_.origin + grid_.spacing * (turn_ * Point(cell.first + 0.5, cell.second + 0.5));
  }

  struct CellPath {
    std::vector<Point> cells;    // path to the farthest broken cell; empty if there is none
    std::vector<Point> reached;  // all broken cells that can be reached
  };
  // Path of broken cells from the cells around a crack's end to the broken cell that is the most steps away. Cells that
  // share only a corner are neighbours, too, because bonds along a slanted crack break later or never.
  CellPath path_from(const Point& end) const {
    std::map<Cell, Cell> came_from;
    std::queue<Cell> next;
    const Cell own = cell_at(end);
    for (const Cell& cell : broken_around(own)) came_from.emplace(cell, cell), next.push(cell);
    CellPath path;
    Cell last = own;
    while (!next.empty()) {
      last = next.front();
      next.pop();
      path.reached.push_back(middle_of(last));
      for (const Cell& cell : broken_around(last))
        if (came_from.emplace(cell, last).second) next.push(cell);
    }
    if (path.reached.empty()) return path;
    for (Cell cell = last;; cell = came_from.at(cell)) {
      path.cells.push_back(middle_of(cell));
      if (came_from.at(cell) == cell) break;
    }
    std::reverse(path.cells.begin(), path.cells.end());
    return path;
  }

 private:
  std::vector<Cell> broken_around(const Cell& own) const {
    std::vector<Cell> found;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        if (const Cell cell{own.first + x, own.second + y}; broken_.count(cell) > 0) found.push_back(cell);
    return found;
  }

  LatticeGrid grid_;
  Eigen::Matrix2d turn_;
  std::vector<Point> middles_;
  std::set<Cell> broken_;  // cells with a side that has broken
};

bool is_in(const scene::Scene& scene, const Discretization& d, const Point& place, bool lattices_only) {
  return std::any_of(d.regions.begin(), d.regions.end(), [&](const auto& region) {
    return (!lattices_only || region->lattice_grid()) && scene::contains(scene, region->id(), place, d.tolerance);
  });
}

// Fits a straight line to the last stretch, of the length `part`, of a path; sets the tip's place and direction by this
// line.
void fit_end(TipAxes& axes, double part) {
  const Point end = axes.path.back();
  Point middle = Point::Zero();
  std::vector<Point> last;
  for (const Point& p : axes.path)
    if ((p - end).norm() <= part) last.push_back(p), middle += p;
  middle /= static_cast<double>(last.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Point& p : last) spread += (p - middle) * (p - middle).transpose();
  Point along = linalg::symmetric_modes(spread).vectors.col(1);
  if (along.dot(end - last.front()) < 0) along = -along;
  axes.direction = along;
  axes.place = middle + along.dot(end - middle) * along;
}

// Distance from the tip [m] within which a crack of broken cells stays within one spacing of the straight line behind
// the tip.
double straight_length(const TipAxes& axes) {
  double reached = 0;
  for (std::size_t i = axes.path.size() - 1; i > 0; --i) {
    const Segment piece{axes.path[i], axes.path[i - 1]};
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * piece.length() / axes.spacing - 1e-6)));
    for (int k = 1; k <= parts; ++k) {
      const Point local = axes.into(piece.at(static_cast<double>(k) / parts) - axes.place);
      if (std::abs(local.y()) > axes.spacing || local.x() > axes.spacing) return reached;
      reached = std::max(reached, local.norm());
    }
  }
  return reached;
}

// Radius of the largest circle around the tip in which the crack is one piece that ends at the tip.
double reach_of(const TipAxes& axes) {
  std::vector<double> from_tip;  // distances of places on the path, from its far end on
  for (std::size_t i = 0; i + 1 < axes.path.size(); ++i) {
    const Segment piece{axes.path[i], axes.path[i + 1]};
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * piece.length() / axes.spacing - 1e-6)));
    for (int k = 0; k < parts; ++k) from_tip.push_back((piece.at(static_cast<double>(k) / parts) - axes.place).norm());
  }
  double radius = from_tip.empty() ? 0 : from_tip.front(), before = 0;
  // A crack must not leave the circle along its path and enter it again. The radius shrinks until this holds.
  while (radius != before) {
    before = radius;
    double nearest = radius;
    for (const double distance : from_tip) {
      nearest = std::min(nearest, distance);
      if (nearest < radius && radius <= distance) radius = nearest;
    }
  }
  return radius;
}

double clear_radius(const LatticeTip& tip, const std::vector<Point>& broken) {
  double radius = tip.axes.is_rough ? straight_length(tip.axes) : reach_of(tip.axes);
  const double beside = std::max(1.5 * tip.axes.spacing, 0.5 * tip.horizon);
  for (const Point& middle : broken) {
    const double from_tip = (middle - tip.axes.place).norm();
    if (from_tip - tip.axes.spacing >= radius || polyline_distance(tip.axes.path, middle) <= beside) continue;
    radius = std::max(0.0, from_tip - tip.axes.spacing);
  }
  return radius;
}

class TipSearch {
 public:
  explicit TipSearch(const BondedBody& body) : body_(body) {}

  // Adds the tip at an end of a crack to `tips`, unless this end is a mouth or has reached an edge.
  void add(int crack, int end, std::vector<Point> path, std::vector<LatticeTip>& tips) {
    const Region* region = region_at(path.back());
    if (!region) return;
    const LatticeGrid grid = *region->lattice_grid();
    const Point ahead = (path.back() - path[path.size() - 2]).normalized();
    if (!is_in(body_.scene, body_.discretization, path.back() + 1e-3 * grid.spacing * ahead, false)) return;
    LatticeTip tip{crack,        end, region->id(), {path.back(), ahead, path, grid.spacing, region->elasticity()},
                   grid.horizon, 0,   false,        false};
    const BrokenFaces& faces = faces_of(*region, grid);
    const BrokenFaces::CellPath broken = faces.path_from(path.back());
    if (broken.cells.size() > 1) {
      tip.grown = true;
      for (const Point& cell : broken.cells)
        if (faces.cell_at(cell) != faces.cell_at(path.back())) tip.axes.path.push_back(cell);
      // A crack that has broken through to an edge has no tip at this end of it.
      if (!std::all_of(broken.reached.begin(), broken.reached.end(),
                       [&](const Point& cell) { return is_in(body_.scene, body_.discretization, cell, false); }))
        return;
      tip.axes.is_rough = true;
      fit_end(tip.axes, 2 * tip.horizon);
      tip.branched = std::any_of(broken.reached.begin(), broken.reached.end(), [&](const Point& cell) {
        return polyline_distance(tip.axes.path, cell) > tip.horizon;
      });
    }
    if (is_in(body_.scene, body_.discretization, tip.axes.place, true)) tip.clear = clear_radius(tip, faces.middles());
    tips.push_back(std::move(tip));
  }

  // Tip at the end of a known path. Results of the tip remain unknown if it lies outside of all lattices.
  LatticeTip at(const KnownTip& known) {
    const Point& place = known.path.back();
    LatticeTip tip{known.crack, known.end, 0, {place, known.direction, known.path, 1, {}}, 1, 0, known.grown, false};
    const Region* region = region_at(place);
    if (!region || known.path.size() < 2) return tip;
    const LatticeGrid grid = *region->lattice_grid();
    tip.region = region->id(), tip.horizon = grid.horizon;
    tip.axes.spacing = grid.spacing, tip.axes.elasticity = region->elasticity();
    tip.clear = clear_radius(tip, faces_of(*region, grid).middles());
    return tip;
  }

 private:
  const Region* region_at(const Point& place) const {
    for (const auto& region : body_.discretization.regions)
      if (region->lattice_grid() && scene::contains(body_.scene, region->id(), place, body_.discretization.tolerance))
        return region.get();
    return nullptr;
  }
  const BrokenFaces& faces_of(const Region& region, const LatticeGrid& grid) {
    return faces_.try_emplace(region.id(), body_, grid).first->second;
  }

  const BondedBody& body_;
  std::map<int, BrokenFaces> faces_;  // by region
};

}  // namespace

std::vector<LatticeTip> find_lattice_tips(const BondedBody& body) {
  std::vector<LatticeTip> tips;
  TipSearch search(body);
  for (std::size_t c = 0; c < body.cracks.size(); ++c) {
    // An initial crack through material points has been shifted beside them. The shifted crack is used here, because it
    // decides on which side the points lie.
    const std::vector<Point>& points = body.cracks[c].points;
    if (!body.discretization.cracks[c].cuts_bonds() || points.size() < 2) continue;
    const std::vector<Point> reversed(points.rbegin(), points.rend());
    search.add(static_cast<int>(c) + 1, 0, reversed, tips);
    search.add(static_cast<int>(c) + 1, 1, points, tips);
  }
  return tips;
}

std::vector<LatticeTip> lattice_tips_at(const BondedBody& body, const std::vector<KnownTip>& known) {
  std::vector<LatticeTip> tips;
  TipSearch search(body);
  for (const KnownTip& tip : known) tips.push_back(search.at(tip));
  return tips;
}

}  // namespace bempd::regions

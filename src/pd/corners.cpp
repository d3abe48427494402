#include "pd/corners.hpp"

#include <algorithm>

#include "pd/layer_balance.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;
using Eigen::Vector4d;

constexpr double least_corner_ratio = 0.02;  // bound on a stiffness over its bulk value
constexpr double rounding = 1e-13;

// Sets `mark` to 1 for the points closer to `center` than `radius`.
void mark_around(const CellLattice& lattice, const Vector2i& center, int radius, std::vector<std::uint8_t>& mark) {
  for (int dy = -radius + 1; dy < radius; ++dy) {
    for (int dx = -radius + 1; dx < radius; ++dx) {
      if (dx * dx + dy * dy >= radius * radius) continue;
      const int i = lattice.find_point(center + Vector2i(dx, dy));
      if (i >= 0) mark[i] = 1;
    }
  }
}

bool is_corner(const CellGrid& cells, const Vector2i& p) {
  const auto [ll, lr, ul, ur] = cells.around(p);
  const int count = ll + lr + ul + ur;
  return count == 1 || count == 3 || (count == 2 && ll == ur);
}

// Flags of the points whose bonds may change: points around corners, and points around any other point with missing
// third moments (missing_moments()).
std::vector<std::uint8_t> adjustable_points(const CellLattice& lattice, const CellGrid& cells, int m,
                                            const std::vector<Vector4d>& missing) {
  const int radius = 2 * m + 1;
  std::vector<std::uint8_t> near(lattice.point_count(), 0), core(lattice.point_count(), 0);
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (!is_corner(cells, lattice.point(i))) continue;
    mark_around(lattice, lattice.point(i), radius, near);
    mark_around(lattice, lattice.point(i), radius - 2, core);
  }
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (!core[i] && missing[i].lpNorm<Eigen::Infinity>() > rounding)
      mark_around(lattice, lattice.point(i), m + 1, near);
  }
  return near;
}

// Index of the bond between two points, -1 if there is none.
int find_bond(const DraftBonds& draft, int first, int second) {
  const std::pair ends = std::minmax(first, second);
  const auto before = [](const DraftBond& b, const std::pair<int, int>& e) { return std::pair(b.first, b.second) < e; };
  const auto at = std::lower_bound(draft.bonds.begin(), draft.bonds.end(), std::pair<int, int>(ends), before);
  const bool found = at != draft.bonds.end() && at->first == ends.first && at->second == ends.second;
  return found ? static_cast<int>(at - draft.bonds.begin()) : -1;
}

// Whether the lattice is symmetric under `map`, which maps points to points.
template <class Map>
bool symmetric_under(const CellLattice& lattice, const CellGrid& cells, const Map& map) {
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Vector2i& p = lattice.point(i);
    if (lattice.find_point(map(p)) < 0) return false;
    // The image of a cell has its lower left corner at the smaller coordinates of the images of two opposite corners.
    const Vector2i a = map(p), b = map(p + Vector2i(1, 1));
    if (cells.has(p) && !cells.has(a.cwiseMin(b))) return false;
  }
  return true;
}

// Replaces the stiffness of each bond in `free` by the mean of the bond's own and that of its image under `map`. Points
// still have no missing third moments then, and the stiffnesses become symmetric to the last bit.
template <class Map>
void average(const CellLattice& lattice, const std::vector<int>& free, const Map& map, DraftBonds& draft) {
  std::vector<double> means;
  for (const int b : free) {
    const DraftBond& bond = draft.bonds[b];
    const int image = find_bond(draft, lattice.find_point(map(lattice.point(bond.first))),
                                lattice.find_point(map(lattice.point(bond.second))));
    means.push_back(image < 0 ? bond.stiffness : 0.5 * (bond.stiffness + draft.bonds[image].stiffness));
  }
  for (std::size_t k = 0; k < free.size(); ++k) draft.bonds[free[k]].stiffness = means[k];
}

// Makes the stiffnesses symmetric if the lattice is symmetric. A symmetric body must break symmetrically, which
// rounding errors of the solver would prevent.
void symmetrise(const CellLattice& lattice, const CellGrid& cells, const std::vector<int>& free, DraftBonds& draft) {
  const Vector2i sum = lattice.lower() + lattice.upper(), size = lattice.upper() - lattice.lower();
  const Vector2i low = lattice.lower();
  const auto attempt = [&](const auto& map) {
    if (!symmetric_under(lattice, cells, map)) return false;
    average(lattice, free, map, draft);
    return true;
  };
  const bool x = attempt([&](const Vector2i& p) { return Vector2i(sum.x() - p.x(), p.y()); });
  const bool y = attempt([&](const Vector2i& p) { return Vector2i(p.x(), sum.y() - p.y()); });
  if (!x && !y) attempt([&](const Vector2i& p) { return Vector2i(sum - p); });
  if (size.x() != size.y()) return;
  attempt([&](const Vector2i& p) { return Vector2i(low + (p - low).reverse()); });
  if (x && y) return;
  attempt([&](const Vector2i& p) { return Vector2i(lattice.upper() - (p - low).reverse()); });
}

}  // namespace

std::vector<Point> surface_vectors(const CellLattice& lattice, const CellGrid& cells) {
  std::vector<Point> surface;
  surface.reserve(static_cast<std::size_t>(lattice.point_count()));
  for (int i = 0; i < lattice.point_count(); ++i) surface.push_back(cells.surface_vector(lattice.point(i)));
  return surface;
}

bool balance_corners(const CellLattice& lattice, const CellGrid& cells, int horizon_ratio, int threads,
                     DraftBonds& draft) {
  const std::vector<Point> surface = surface_vectors(lattice, cells);
  const std::vector<std::uint8_t> near =
      adjustable_points(lattice, cells, horizon_ratio, missing_moments(surface, draft));
  std::vector<int> free;
  for (std::size_t k = 0; k < draft.bonds.size(); ++k) {
    DraftBond& b = draft.bonds[k];
    b.free = b.in_layer && (near[b.first] || near[b.second]);
    if (b.free) free.push_back(static_cast<int>(k));
  }
  if (!balance_layer(surface, least_corner_ratio, threads, draft)) return false;
  symmetrise(lattice, cells, free, draft);
  return true;
}

}  // namespace bempd::pd

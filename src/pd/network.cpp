#include "pd/network.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "cancellation.hpp"
#include "pd/cell_grid.hpp"
#include "pd/corners.hpp"
#include "pd/face_template.hpp"
#include "phase.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;

// Removes thin cells from `cells`: cells where the body is one cell wide. Every thin cell gets a network of its own
// between nearest neighbours, and the rest of the body has faces where thin cells were. Networks of disjoint parts of a
// body add up to an exact network, because the right-hand sides of the moment equations are sums over cells.
void remove_thin_cells(const CellLattice& lattice, CellGrid& cells) {
  const auto thin = [&](const Vector2i& c) {
    const Vector2i x(1, 0), y(0, 1);
    return cells.has(c) && ((!cells.has(c - x) && !cells.has(c + x)) || (!cells.has(c - y) && !cells.has(c + y)));
  };
  std::vector<Vector2i> found(1);
  while (!found.empty()) {
    found.clear();
    for (int y = lattice.lower().y(); y < lattice.upper().y(); ++y) {
      for (int x = lattice.lower().x(); x < lattice.upper().x(); ++x) {
        if (thin({x, y})) found.emplace_back(x, y);
      }
    }
    for (const Vector2i& c : found) cells.remove(c);
  }
}

// Stiffness that the network of nearest neighbours gives a bond: C1111 / 3 for each cell of which the bond is an edge
// or diagonal. Only cells for which in(cell) is true count.
template <class In>
double cell_network_stiffness(const Vector2i& from, const Vector2i& step, const In& in) {
  const int a = step.x(), b = step.y();
  if (a * a + b * b > 2) return 0;
  const Vector2i corner(a < 0 ? from.x() - 1 : from.x(), from.y());
  int count = in(corner);
  if (b == 0) count += in(corner - Vector2i(0, 1));
  if (a == 0) count += in(corner - Vector2i(1, 0));
  return count / 3.0;
}

// Ratio of a bond's stiffness to its bulk stiffness by the templates of the nearest faces along both axes. The changes
// by both templates are added, because the moment equations are linear; little is then left to correct at corners.
double template_ratio(const LatticeTemplates& templates, const CellGrid& cells, const Vector2i& from,
                      const Vector2i& step) {
  const int a = std::abs(step.x()), b = step.y();
  const CellGrid::Depth lower = cells.depth(from), upper = cells.depth(from + step);
  const CellGrid::Depth &left = step.x() >= 0 ? lower : upper, &right = step.x() >= 0 ? upper : lower;
  const int below = std::max(0, std::min<int>(lower.below, upper.below - b));
  const int above = std::max(0, std::min<int>(upper.above, lower.above - b));
  const int before = std::max(0, std::min<int>(left.left, right.left - a));
  const int behind = std::max(0, std::min<int>(right.right, left.right - a));
  return templates.ratio(below, above, a, b) + (templates.ratio(before, behind, b, a) - 1);
}

// Makes all bonds between points that see each other in the thick part of the body, with template stiffnesses, and the
// bonds of thin cells, whose stiffness is 0 until add_thin_cells() sets it.
DraftBonds draft_bonds(const CellLattice& lattice, const CellGrid& cells, const LatticeTemplates& templates) {
  const int m = templates.horizon_ratio;
  const auto thin = [&](const Vector2i& c) { return lattice.has_cell(c) && !cells.has(c); };
  DraftBonds draft{templates.family, {}};
  draft.bonds.reserve(templates.family.size() * static_cast<std::size_t>(lattice.point_count()));
  const Phase phase("bonds of a lattice", lattice.point_count());
  for (int i = 0; i < lattice.point_count(); ++i) {
    check_cancelled();
    if (i % 1024 == 0) phase.reach(i);
    const Vector2i& p = lattice.point(i);
    const Vector2i deep(2 * m, 2 * m), near(m - 1, m - 1);
    const bool bulk = cells.filled(p - deep, p + deep);
    const bool clear = bulk || cells.filled(p - near, p + near);
    for (std::size_t o = 0; o < templates.family.size(); ++o) {
      const BondOffset& offset = templates.family[o];
      const Vector2i step = offset.step.cast<int>(), q = p + step;
      const int j = lattice.find_point(q);
      if (j < 0) continue;
      if (clear || cells.in_sight(p, step)) {
        const double ratio = bulk ? 1 : template_ratio(templates, cells, p, step);
        draft.bonds.push_back({i, j, static_cast<int>(o), true, false, offset.bulk_stiffness * ratio});
      } else if (cell_network_stiffness(p, step, thin) > 0) {
        draft.bonds.push_back({i, j, static_cast<int>(o), false, false, 0});
      }
    }
  }
  return draft;
}

// Adds the stiffnesses of the network of nearest neighbours for thin cells, which are the cells that `thick` lacks.
void add_thin_cells(const CellLattice& lattice, const CellGrid& thick, DraftBonds& draft) {
  const auto thin = [&](const Vector2i& c) { return lattice.has_cell(c) && !thick.has(c); };
  for (DraftBond& b : draft.bonds) {
    const Vector2i step = draft.offsets[b.offset].step.cast<int>();
    b.stiffness += cell_network_stiffness(lattice.point(b.first), step, thin);
  }
}

DraftBonds nearest_neighbours(const CellLattice& lattice, const BondKernel& kernel) {
  const auto in = [&](const Vector2i& c) { return lattice.has_cell(c); };
  DraftBonds draft{bond_family(2, kernel), {}};
  for (int i = 0; i < lattice.point_count(); ++i) {
    check_cancelled();
    for (std::size_t o = 0; o < draft.offsets.size(); ++o) {
      const Vector2i step = draft.offsets[o].step.cast<int>();
      const double stiffness = cell_network_stiffness(lattice.point(i), step, in);
      if (stiffness > 0)
        draft.bonds.push_back(
            {i, lattice.find_point(lattice.point(i) + step), static_cast<int>(o), false, false, stiffness});
    }
  }
  return draft;
}

}  // namespace

Network build_network(const CellLattice& lattice, int horizon_ratio, const PlaneElasticity& elasticity, int threads,
                      const BondKernel& kernel) {
  assert(horizon_ratio >= 2 && horizon_ratio <= 8);
  const std::vector<Point> surface = surface_vectors(lattice, CellGrid(lattice, 1));
  if (horizon_ratio > 2) {
    const LatticeTemplates& templates = lattice_templates(horizon_ratio, kernel);
    CellGrid thick(lattice, 2 * horizon_ratio);
    remove_thin_cells(lattice, thick);
    thick.finish(3 * horizon_ratio);
    DraftBonds draft = draft_bonds(lattice, thick, templates);
    if (balance_corners(lattice, thick, horizon_ratio, threads, draft)) {
      add_thin_cells(lattice, thick, draft);
      Network network = finish_network(surface, std::move(draft), elasticity);
      if (network.max_residual < 1e-10 && network.min_weight_ratio > 0) return network;
    }
  }
  Network network = finish_network(surface, nearest_neighbours(lattice, kernel), elasticity);
  network.reduced = horizon_ratio > 2;
  return network;
}

}  // namespace bempd::pd

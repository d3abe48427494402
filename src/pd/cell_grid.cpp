#include "pd/cell_grid.hpp"

#include <algorithm>
#include <cstdlib>

namespace bempd::pd {

using Eigen::Vector2i;

CellGrid::CellGrid(const CellLattice& lattice, int margin) {
  const Vector2i pad(margin, margin), size = lattice.upper() - lattice.lower() + 2 * pad;
  origin_ = lattice.lower() - pad;
  width_ = size.x();
  height_ = size.y();
  cells_.assign(static_cast<std::size_t>(width_) * height_, 0);
  for (int y = lattice.lower().y(); y < lattice.upper().y(); ++y) {
    for (int x = lattice.lower().x(); x < lattice.upper().x(); ++x) {
      cells_[index({x, y})] = lattice.has_cell({x, y});
    }
  }
}

void CellGrid::finish(int depth_limit) {
  sums_.assign(static_cast<std::size_t>(width_ + 1) * (height_ + 1), 0);
  runs_.assign(cells_.size(), {});
  const auto longer = [&](std::int16_t run) { return static_cast<std::int16_t>(std::min(run + 1, depth_limit)); };
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t c = static_cast<std::size_t>(y) * width_ + x,
                        s = static_cast<std::size_t>(y) * (width_ + 1) + x;
      sums_[s + width_ + 2] = cells_[c] + sums_[s + 1] + sums_[s + width_ + 1] - sums_[s];
      if (!cells_[c]) continue;
      runs_[c].below = longer(runs_[c - width_].below);
      runs_[c].left = longer(runs_[c - 1].left);
    }
  }
  for (std::size_t c = cells_.size(); c-- > 0;) {
    if (!cells_[c]) continue;
    runs_[c].above = longer(runs_[c + width_].above);
    runs_[c].right = longer(runs_[c + 1].right);
  }
}

bool CellGrid::filled(const Vector2i& from, const Vector2i& to) const {
  const Vector2i a = from - origin_, b = to - origin_;
  if (a.x() < 0 || a.y() < 0 || b.x() > width_ || b.y() > height_) return false;
  const auto sum = [&](int x, int y) { return sums_[static_cast<std::size_t>(y) * (width_ + 1) + x]; };
  return sum(b.x(), b.y()) - sum(a.x(), b.y()) - sum(b.x(), a.y()) + sum(a.x(), a.y()) ==
         (b.x() - a.x()) * (b.y() - a.y());
}

std::array<bool, 4> CellGrid::around(const Vector2i& p) const {
  const std::size_t c = index(p);
  return {cells_[c - width_ - 1] != 0, cells_[c - width_] != 0, cells_[c - 1] != 0, cells_[c] != 0};
}

// Depths of a point. In each direction a grid line leads away from the point, with a cell on each of its two sides; the
// smaller depth of these cells counts. At a point on a face one of both cells may be absent; then the other cell
// counts.
CellGrid::Depth CellGrid::depth(const Vector2i& p) const {
  const auto combine = [](std::int16_t a, std::int16_t b) { return a == 0 ? b : b == 0 ? a : std::min(a, b); };
  const std::size_t c = index(p);
  const Depth &ll = runs_[c - width_ - 1], &lr = runs_[c - width_], &ul = runs_[c - 1], &ur = runs_[c];
  return {combine(ll.below, lr.below), combine(ul.above, ur.above), combine(ll.left, ul.left),
          combine(lr.right, ur.right)};
}

Eigen::Vector2d CellGrid::surface_vector(const Vector2i& p) const {
  const auto [ll, lr, ul, ur] = around(p);
  return 0.5 * Eigen::Vector2d(ll - lr + ul - ur, ll + lr - ul - ur);
}

bool CellGrid::in_sight(const Vector2i& from, const Vector2i& step) const {
  const int a = step.x(), b = step.y();
  if (b == 0 || a == 0) {
    const int count = std::abs(a + b);
    const Vector2i unit = step / count, side = b == 0 ? Vector2i(0, 1) : Vector2i(1, 0);
    for (int k = 0; k < count; ++k) {
      const Vector2i cell = from + k * unit;
      if (!has(cell) && !has(cell - side)) return false;
    }
    return true;
  }
  // Cells that the bond crosses: in each column, the rows between the bond's heights at the two sides of the column.
  const int columns = std::abs(a), rise = std::abs(b), sx = a > 0 ? 1 : -1, sy = b > 0 ? 1 : -1;
  for (int i = 0; i < columns; ++i) {
    const int first = i * rise / columns, last = ((i + 1) * rise + columns - 1) / columns;
    for (int j = first; j < last; ++j) {
      if (!has({from.x() + (sx > 0 ? i : -i - 1), from.y() + (sy > 0 ? j : -j - 1)})) return false;
    }
  }
  return true;
}

}  // namespace bempd::pd

#include "pd/cell_lattice.hpp"

#include <algorithm>
#include <cassert>

namespace bempd::pd {

template <class Has>
void CellLattice::number_points(const Has& has) {
  const Eigen::Vector2i size = upper_ - lower_;
  point_at_.assign(static_cast<std::size_t>(size.x() + 1) * (size.y() + 1), -1);
  for (int y = 0; y <= size.y(); ++y) {
    for (int x = 0; x <= size.x(); ++x) {
      const Eigen::Vector2i at = lower_ + Eigen::Vector2i(x, y);
      if (!has(at)) continue;
      point_at_[static_cast<std::size_t>(y) * (size.x() + 1) + x] = point_count();
      points_.push_back(at);
    }
  }
}

CellLattice::CellLattice(const std::vector<std::vector<Eigen::Vector2i>>& loops) {
  assert(!loops.empty() && loops.front().size() >= 4);
  lower_ = upper_ = loops.front().front();
  for (const Eigen::Vector2i& corner : loops.front()) {
    lower_ = lower_.cwiseMin(corner);
    upper_ = upper_.cwiseMax(corner);
  }
  mark_cells(loops);
  number_corners();
}

void CellLattice::number_corners() {
  number_points([this](const Eigen::Vector2i& at) {
    return has_cell(at) || has_cell(at - Eigen::Vector2i(1, 0)) || has_cell(at - Eigen::Vector2i(0, 1)) ||
           has_cell(at - Eigen::Vector2i(1, 1));
  });
}

CellLattice CellLattice::union_of(const std::vector<Part>& parts) {
  assert(!parts.empty());
  CellLattice out;
  out.lower_ = parts.front().lattice->lower() + parts.front().shift;
  out.upper_ = parts.front().lattice->upper() + parts.front().shift;
  for (const Part& part : parts) {
    out.lower_ = out.lower_.cwiseMin(part.lattice->lower() + part.shift);
    out.upper_ = out.upper_.cwiseMax(part.lattice->upper() + part.shift);
  }
  const Eigen::Vector2i size = out.upper_ - out.lower_;
  out.cells_.assign(static_cast<std::size_t>(size.x()) * size.y(), 0);
  for (const Part& part : parts) {
    for (const Eigen::Vector2i& corner : part.lattice->points_) {
      if (!part.lattice->has_cell(corner)) continue;
      const Eigen::Vector2i at = corner + part.shift - out.lower_;
      out.cells_[static_cast<std::size_t>(at.y()) * size.x() + at.x()] = 1;
    }
  }
  out.cell_count_ = static_cast<int>(std::count(out.cells_.begin(), out.cells_.end(), 1));
  out.number_corners();
  return out;
}

CellLattice CellLattice::centres_of(const CellLattice& cells) {
  CellLattice out;
  out.lower_ = cells.lower();
  out.upper_ = cells.upper() - Eigen::Vector2i(1, 1);
  out.number_points([&](const Eigen::Vector2i& at) { return cells.has_cell(at); });
  const Eigen::Vector2i size = out.upper_ - out.lower_;
  out.cells_.assign(static_cast<std::size_t>(size.x()) * size.y(), 0);
  for (int y = 0; y < size.y(); ++y) {
    for (int x = 0; x < size.x(); ++x) {
      const Eigen::Vector2i at = out.lower_ + Eigen::Vector2i(x, y);
      const bool whole = cells.has_cell(at) && cells.has_cell(at + Eigen::Vector2i(1, 0)) &&
                         cells.has_cell(at + Eigen::Vector2i(0, 1)) && cells.has_cell(at + Eigen::Vector2i(1, 1));
      out.cells_[static_cast<std::size_t>(y) * size.x() + x] = whole;
      out.cell_count_ += whole;
    }
  }
  return out;
}

// Marks the cells inside the loops, row by row. Along the middle of a row, the cells between an odd crossing with the
// loops and the next crossing lie inside.
void CellLattice::mark_cells(const std::vector<std::vector<Eigen::Vector2i>>& loops) {
  const Eigen::Vector2i size = upper_ - lower_;
  std::vector<std::vector<int>> crossings(size.y());
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Eigen::Vector2i a = loop[k] - lower_, b = loop[(k + 1) % loop.size()] - lower_;
      assert(a.x() == b.x() || a.y() == b.y());
      for (int y = std::min(a.y(), b.y()); y < std::max(a.y(), b.y()); ++y) crossings[y].push_back(a.x());
    }
  }
  cells_.assign(static_cast<std::size_t>(size.x()) * size.y(), 0);
  for (int y = 0; y < size.y(); ++y) {
    std::sort(crossings[y].begin(), crossings[y].end());
    for (std::size_t k = 0; k + 1 < crossings[y].size(); k += 2) {
      for (int x = crossings[y][k]; x < crossings[y][k + 1]; ++x) {
        cells_[static_cast<std::size_t>(y) * size.x() + x] = 1;
        ++cell_count_;
      }
    }
  }
}

int CellLattice::find_point(const Eigen::Vector2i& at) const {
  if (at.x() < lower_.x() || at.y() < lower_.y() || at.x() > upper_.x() || at.y() > upper_.y()) return -1;
  return point_at_[static_cast<std::size_t>(at.y() - lower_.y()) * (upper_.x() - lower_.x() + 1) + at.x() - lower_.x()];
}

bool CellLattice::has_cell(const Eigen::Vector2i& at) const {
  if (at.x() < lower_.x() || at.y() < lower_.y() || at.x() >= upper_.x() || at.y() >= upper_.y()) return false;
  return cells_[static_cast<std::size_t>(at.y() - lower_.y()) * (upper_.x() - lower_.x()) + at.x() - lower_.x()] != 0;
}

std::array<int, 4> CellLattice::cell_corners(const Eigen::Vector2i& at) const {
  assert(has_cell(at));
  return {find_point(at), find_point(at + Eigen::Vector2i(1, 0)), find_point(at + Eigen::Vector2i(0, 1)),
          find_point(at + Eigen::Vector2i(1, 1))};
}

int CellLattice::cells_around(int point) const {
  const Eigen::Vector2i& p = points_[point];
  return has_cell(p) + has_cell(p - Eigen::Vector2i(1, 0)) + has_cell(p - Eigen::Vector2i(0, 1)) +
         has_cell(p - Eigen::Vector2i(1, 1));
}

bool CellLattice::is_pinched(int point) const {
  const Eigen::Vector2i& p = points_[point];
  const bool rising = has_cell(p) && has_cell(p - Eigen::Vector2i(1, 1));
  const bool falling = has_cell(p - Eigen::Vector2i(1, 0)) && has_cell(p - Eigen::Vector2i(0, 1));
  return rising != falling && cells_around(point) == 2;
}

}  // namespace bempd::pd

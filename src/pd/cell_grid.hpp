#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Copy of the cells of a lattice on a grid with a margin of empty cells, so that access to neighbouring cells needs no
// range check. The grid tells what the stiffness of bonds depends on: the depth of points below faces, visibility
// between points, and surface vectors.
class CellGrid {
 public:
  CellGrid(const CellLattice& lattice, int margin);

  bool has(const Eigen::Vector2i& cell) const { return cells_[index(cell)] != 0; }
  void remove(const Eigen::Vector2i& cell) { cells_[index(cell)] = 0; }

  // Prepares the queries below; to be called after the last removal of cells. Depths are limited to `depth_limit`.
  void finish(int depth_limit);

  // Whether the lattice has every cell whose lower left corner lies in [from, to).
  bool filled(const Eigen::Vector2i& from, const Eigen::Vector2i& to) const;

  // Depth of a point below the faces around it: numbers of cells from the point to the next face below, above, to the
  // left and to the right, at most the depth limit.
  struct Depth {
    std::int16_t below = 0, above = 0, left = 0, right = 0;
  };
  Depth depth(const Eigen::Vector2i& point) const;

  // Whether the bond from a point along `step` stays in the union of the closed cells; it may run along a face.
  bool in_sight(const Eigen::Vector2i& from, const Eigen::Vector2i& step) const;

  // Surface vector of a point: sum of the outward normals of the faces that meet there, each times half the face's
  // length.
  Eigen::Vector2d surface_vector(const Eigen::Vector2i& point) const;

  // Presence of the cells around a point: lower left, lower right, upper left, upper right.
  std::array<bool, 4> around(const Eigen::Vector2i& point) const;

 private:
  std::size_t index(const Eigen::Vector2i& cell) const {
    return static_cast<std::size_t>(cell.y() - origin_.y()) * width_ + (cell.x() - origin_.x());
  }
  Eigen::Vector2i origin_;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> cells_;
  std::vector<int> sums_;    // number of cells below and to the left of each grid corner
  std::vector<Depth> runs_;  // numbers of cells from each cell to the next faces, the cell itself included
};

}  // namespace bempd::pd

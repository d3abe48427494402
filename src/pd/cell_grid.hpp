#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pd/bond_family.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Copy of the cells of a lattice on a grid with a margin of empty cells, so that neighbours need no range checks. It
// tells what bonds depend on: the depth of points below faces, visibility between points, and surface vectors.
class CellGrid {
 public:
  CellGrid(const CellLattice& lattice, int margin);

  bool has(const Eigen::Vector2i& cell) const { return cells_[index(cell)] != 0; }
  void remove(const Eigen::Vector2i& cell) { cells_[index(cell)] = 0; }

  // Prepares the queries below; to be called after the last removal of cells. Depths are limited to `depth_limit`.
  void finish(int depth_limit);

  // Whether all cells are present whose lower left corners lie in [from, to).
  bool filled(const Eigen::Vector2i& from, const Eigen::Vector2i& to) const;

  // Numbers of present cells in a row from a point to the next face: below, above, left and right, up to the depth
  // limit.
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
  std::vector<int> sums_;    // cells below and left of a corner of the grid
  std::vector<Depth> runs_;  // per cell, itself included
};

}  // namespace bempd::pd

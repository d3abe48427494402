#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace bempd::pd {

// Union of unit cells bounded by simple rectilinear loops with integer corners: the outer loop counter-clockwise, holes
// clockwise. Material points are the corners of the cells, those on the boundary included, numbered row by row (y
// first, then x). All lengths are in units of the lattice spacing.
class CellLattice {
 public:
  explicit CellLattice(const std::vector<std::vector<Eigen::Vector2i>>& loops);

  // Lattice whose material points are the centres of the cells of another lattice, `cells`. The point (i, j) of the new
  // lattice is the centre of the cell (i, j) of `cells`, so coordinates are smaller by (1/2, 1/2). A cell of the new
  // lattice joins the centres of four neighbouring cells of `cells`; where `cells` is one cell wide, points belong to
  // no cell.
  static CellLattice centres_of(const CellLattice& cells);

  // Part of a union of lattices: all cells of one lattice, moved by a shift.
  struct Part {
    const CellLattice* lattice;
    Eigen::Vector2i shift;
  };
  static CellLattice union_of(const std::vector<Part>& parts);

  int point_count() const { return static_cast<int>(points_.size()); }
  const Eigen::Vector2i& point(int i) const { return points_[i]; }
  // Index of the material point at grid coordinates `at`, -1 if there is none.
  int find_point(const Eigen::Vector2i& at) const;

  int cell_count() const { return cell_count_; }
  bool has_cell(const Eigen::Vector2i& lower_left) const;
  // Indices of the material points at the corners of a present cell: lower left, lower right, upper left, upper right.
  std::array<int, 4> cell_corners(const Eigen::Vector2i& lower_left) const;

  // Corners of the smallest box that contains all points.
  const Eigen::Vector2i& lower() const { return lower_; }
  const Eigen::Vector2i& upper() const { return upper_; }

  // Number of present cells around a material point: 4 inside, 2 on a straight face, 1 or 3 at a corner.
  int cells_around(int point) const;
  // Whether the body is pinched at a material point: only two of the four cells around the point are present, and they
  // share just this corner.
  bool is_pinched(int point) const;

 private:
  CellLattice() = default;
  void mark_cells(const std::vector<std::vector<Eigen::Vector2i>>& loops);
  // Numbers the grid points `at` of the box for which has(at) holds.
  template <class Has>
  void number_points(const Has& has);
  void number_corners();

  Eigen::Vector2i lower_, upper_;
  int cell_count_ = 0;
  std::vector<std::uint8_t> cells_;  // width * height of the box
  std::vector<int> point_at_;        // (width + 1) * (height + 1), -1 where there is no point
  std::vector<Eigen::Vector2i> points_;
};

}  // namespace bempd::pd

#pragma once

#include <vector>

#include "pd/outlined/chord_search.hpp"

namespace bempd::pd {

// Position of a square lattice: one of its points and the direction of its rows.
struct LatticePlace {
  Point origin = Point::Zero();
  double angle = 0;    // [rad]
  bool fixed = false;  // false: the lattice may be moved if no network is found
};

// Material points of a body with any outline, in units of the spacing: first the nodes of its chords, then the points
// of a lattice inside that keep a gap from the chords.
class OutlinedPoints {
 public:
  OutlinedPoints(const Chords& chords, const LatticePlace& place, double gap, double deepest);

  int count() const { return static_cast<int>(points_.size()); }
  int outline_count() const { return outline_count_; }
  const std::vector<Point>& points() const { return points_; }
  bool on_lattice(int i) const { return i >= outline_count_; }
  const Eigen::Vector2i& lattice_point(int i) const {
    return lattice_points_[static_cast<std::size_t>(i) - outline_count_];
  }
  int find_point(const Eigen::Vector2i& at) const;
  // Distance of a point from the outline, limited to `deepest`.
  double depth(int i) const { return depth_[i]; }
  // Rotation from the x axis to the lattice's rows.
  const Eigen::Matrix2d& turn() const { return turn_; }
  // Coordinates of a place in the lattice, where lattice points have whole numbers.
  Point place_on_lattice(const Point& p) const { return turn_.transpose() * (p - origin_); }

  // Whether the lattice cell with this lower left corner has all its points and does not touch the outline.
  bool has_cell(const Eigen::Vector2i& at) const;
  const Eigen::Vector2i& lower() const { return lower_; }
  const Eigen::Vector2i& upper() const { return upper_; }

 private:
  std::size_t index(const Eigen::Vector2i& at) const {
    return static_cast<std::size_t>(at.y() - lower_.y()) * columns_ + (at.x() - lower_.x());
  }
  bool in_box(const Eigen::Vector2i& at) const {
    return (at.array() >= lower_.array()).all() && (at.array() <= upper_.array()).all();
  }
  void mark_inside(const std::vector<Point>& nodes, const Chords& chords, std::vector<char>& inside) const;
  // Distances from the nearest chord, at most `deepest`, for all points of the lattice grid moved by `shift` along both
  // axes.
  std::vector<double> distances(const std::vector<Point>& nodes, const Chords& chords, double shift,
                                double deepest) const;

  int outline_count_;
  Point origin_;
  Eigen::Matrix2d turn_;
  Eigen::Vector2i lower_, upper_;  // lattice points at the corners of the bounding box
  int columns_ = 0;
  std::vector<Point> points_;
  std::vector<Eigen::Vector2i> lattice_points_;
  std::vector<double> depth_;
  std::vector<int> point_at_;  // point at each lattice point of the box; -1: none
  std::vector<char> clear_cell_;
};

}  // namespace bempd::pd

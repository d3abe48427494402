#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/edge.hpp"

namespace bempd {

// Delaunay triangulation of points that are inserted one after the other (Bowyer and Watson 1981). Coordinates are
// rounded to integers, 2^23 to either side of the box's centre, so that every decision is exact.
class Delaunay {
 public:
  explicit Delaunay(const Box& box);

  // Inserts a point and returns its number; if an earlier point has the same rounded place, returns the number of that
  // point.
  int insert(const Point& p);

  struct Triangle {
    std::array<int, 3> points;      // counter-clockwise; negative: points of the frame around the box
    std::array<int, 3> neighbours;  // triangles across from the points; -1: outside the frame
    bool exists = true;
  };
  // All triangles ever made. Triangles with `exists` = false have been removed.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // Numbers of the triangles that the last insertion made.
  const std::vector<int>& fresh() const { return fresh_; }
  int point_count() const { return static_cast<int>(places_.size()) - frame_points; }

 private:
  struct Place {
    std::int64_t x, y;
  };
  // Side on the rim of the cavity around a new point, with the triangle on its other side (-1: none).
  struct Rim {
    std::array<int, 2> points;
    int beyond;
  };
  static constexpr int frame_points = 3;

  const Place& place(int point) const { return places_[static_cast<std::size_t>(std::int64_t{point} + frame_points)]; }
  // Twice the area of the triangle a, b, c; positive if it is counter-clockwise.
  static std::int64_t turn(const Place& a, const Place& b, const Place& c);
  bool circle_holds(const Triangle& triangle, const Place& p) const;
  int triangle_at(const Place& p) const;
  std::vector<Rim> open_cavity(int first, const Place& p);

  Point centre_;
  double scale_;
  std::vector<Place> places_;
  std::vector<Triangle> triangles_;
  std::vector<int> fresh_;
};

}  // namespace bempd

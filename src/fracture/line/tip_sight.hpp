#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace bempd::fracture {

// What a tip sees: everything except what the face of another crack hides. Holes and inward corners hide nothing here,
// because points are taken the nearer the tip the nearer it is to an outline.
class TipSight {
 public:
  TipSight(const Point& place, const Point& direction, double spacing);

  // Adds a broken bond between neighbours; those that the tip's own crack has broken are left out.
  void add_gone(const Point& middle, const Point& along);

  double nearest_face() const { return nearest_face_; }  // infinite without one
  bool sees(const Point& point) const;

 private:
  struct Piece {
    Point from, to;
  };

  Point place_, direction_;
  double spacing_, nearest_face_;
  std::vector<Piece> faces_;
};

}  // namespace bempd::fracture

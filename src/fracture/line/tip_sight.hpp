#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace bempd::fracture {

// What a tip sees: not what lies behind the face of another crack. Behind holes and beyond inward corners nothing is
// asked, as points are taken the nearer the tip the nearer it is to an outline.
class TipSight {
 public:
  TipSight(const Point& place, const Point& direction, double spacing);

  // Of a bond between neighbours that is gone; what the tip's own crack has broken is left out.
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

#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace bempd::fracture {

// Visibility of stress points (material points whose stress is fitted) from a tip: faces of other cracks hide points
// behind them. Holes and inward corners hide no points, because stress points are taken the closer to the tip, the
// closer the tip is to an outline.
class TipSight {
 public:
  TipSight(const Point& place, const Point& direction, double spacing);

  // Adds a broken bond between neighbours as a segment of a crack face, unless the tip's own crack has broken the bond.
  void add_broken_bond(const Point& middle, const Point& along);

  double nearest_face() const { return nearest_face_; }  // distance [m]; infinite without a face
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

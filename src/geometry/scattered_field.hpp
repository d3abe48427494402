#pragma once

#include <array>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Field through given values at given places, linear on the Delaunay triangles of the places. Outside of the triangles
// the field has the value at the nearest place of their border. If all places lie on one line, the field is linear
// along this line and constant across it.
class ScatteredField {
 public:
  // Creates the field. Throws Error (argument) if two places are the same to 1e-7 of the extent of all places.
  ScatteredField(std::vector<Point> places, std::vector<double> values);

  double at(const Point& place) const;

  const std::vector<Point>& places() const { return places_; }
  const std::vector<double>& values() const { return values_; }

 private:
  void triangulate();
  double on_border(const Point& place) const;

  std::vector<Point> places_;
  std::vector<double> values_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::array<int, 2>> border_;  // sides of triangles (or pieces of the line) on the border
  BoxTree tree_;                            // boxes around the triangles
};

}  // namespace bempd

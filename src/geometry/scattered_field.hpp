#pragma once

#include <array>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Values at places, linear on the Delaunay triangles of the places between; elsewhere the value at the nearest place of
// the triangles' border. Places on one line give values that are linear along it and constant across it.
class ScatteredField {
 public:
  // Throws Error (argument) if two places are the same to 1e-7 of the extent of all.
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
  std::vector<std::array<int, 2>> border_;  // sides of triangles, or of the line, with nothing beyond
  BoxTree tree_;                            // of the triangles
};

}  // namespace bempd

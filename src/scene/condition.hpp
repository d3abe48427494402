#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "geometry/point.hpp"
#include "scene/place.hpp"

namespace bempd::scene {

// Value at one place of a boundary part: constant and proportional part, each with the components x and y.
struct BoundaryValue {
  Point constant = Point::Zero();
  Point proportional = Point::Zero();
};
// Function of the host for values along a boundary part. It receives a place, and the place's distance along the part
// as a fraction of the part's length.
using BoundaryFunction = std::function<BoundaryValue(const Point&, double fraction_of_part)>;

// Values along a boundary part at equally spaced places, linear between them; a single value is uniform.
struct SampledValues {
  std::vector<double> constant, proportional;

  // Constant part of the value at a fraction (0 .. 1) of the length of the boundary part.
  double constant_at(double fraction) const;
  double proportional_at(double fraction) const;

  // Throws Error (argument) if a value is not a finite number.
  void check() const;
};

// Values along a boundary part at given places: linear between them, and constant before the first and behind the last
// place.
struct PlacedValues {
  std::vector<double> fractions;               // places as fractions of the part's length, ascending
  std::vector<double> constant, proportional;  // x and y at each place

  BoundaryValue at(double fraction) const;

  // Throws Error (argument) if a value is not a finite number, or if places are not in ascending order.
  void check() const;
};

using Values = std::variant<SampledValues, BoundaryFunction, PlacedValues>;

// Condition on the boundary: a support or a load. It acts on the `components` 1 (x), 2 (y) or 3 (both).
struct Condition {
  std::shared_ptr<const Place> place;  // null: the condition was removed
  int components = 0;
  Values values;
  std::size_t sample_count = 0;  // number of samples at its creation; 0: values by a function

  bool removed() const { return place == nullptr; }
  BoundaryValue value(const Point& where, double fraction_of_part) const;
  // Value at a place, set to 0 in those components on which the condition does not act.
  BoundaryValue acting_value(const Point& where, double fraction_of_part) const;
  bool acts_on(int component) const { return (components >> component) & 1; }
};

}  // namespace bempd::scene

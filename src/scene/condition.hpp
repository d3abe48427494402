#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "geometry/point.hpp"
#include "scene/place.hpp"

namespace bempd::scene {

// Values at a place of a boundary part: constant and proportional parts, x and y.
struct BoundaryValue {
  Point constant = Point::Zero();
  Point proportional = Point::Zero();
};
// Function of a place and of its distance along the part, as a fraction.
using BoundaryFunction = std::function<BoundaryValue(const Point&, double fraction_of_part)>;

// Values at equally spaced samples, linear between them; one sample is a uniform value.
struct SampledValues {
  std::vector<double> constant, proportional;

  // Constant part at a fraction of the boundary part, 0 .. 1.
  double constant_at(double fraction) const;
  double proportional_at(double fraction) const;

  // Throws Error (argument) for values that are not numbers.
  void check() const;
};

// Values at given places along a part, linear between them, constant before the first and beyond the last one.
struct PlacedValues {
  std::vector<double> fractions;               // of the part, ascending
  std::vector<double> constant, proportional;  // in x and y at each place

  BoundaryValue at(double fraction) const;

  // Throws Error (argument) for values that are not numbers, and for places that are not in order.
  void check() const;
};

using Values = std::variant<SampledValues, BoundaryFunction, PlacedValues>;

// Support or load. Components: 1 x, 2 y, 3 both.
struct Condition {
  std::shared_ptr<const Place> place;  // null: it was removed
  int components = 0;
  Values values;
  std::size_t sample_count = 0;  // number of samples at its creation; 0: values by a function

  bool removed() const { return place == nullptr; }
  BoundaryValue value(const Point& where, double fraction_of_part) const;
  // Value at a place, with 0 in components on which the condition does not act.
  BoundaryValue acting_value(const Point& where, double fraction_of_part) const;
  bool acts_on(int component) const { return (components >> component) & 1; }
};

}  // namespace bempd::scene

#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "geometry/point.hpp"
#include "scene/place.hpp"

namespace bempd::scene {

// Values along a boundary part as functions of the place: constant and proportional parts, x and y.
struct BoundaryValue {
  Point constant = Point::Zero();
  Point proportional = Point::Zero();
};
// Of a place and how far along the part it is, as a fraction.
using BoundaryFunction = std::function<BoundaryValue(const Point&, double fraction_of_part)>;

// Equally spaced samples, linear between them; one sample is a uniform value.
struct SampledValues {
  std::vector<double> constant, proportional;

  // At a fraction of the part, 0 .. 1.
  double constant_at(double fraction) const;
  double proportional_at(double fraction) const;

  // Throws Error (argument) for values that are not numbers.
  void check() const;
};

// Values at places along a part, linear between them and constant beyond the first and the last one.
struct PlacedValues {
  std::vector<double> fractions;               // of the part, ascending
  std::vector<double> constant, proportional;  // in x and y at each place

  BoundaryValue at(double fraction) const;

  // Throws Error (argument) for values that are not numbers, and for places that are not in order.
  void check() const;
};

using Values = std::variant<SampledValues, BoundaryFunction, PlacedValues>;

// A support or a load. Components: 1 x, 2 y, 3 both.
struct Condition {
  std::shared_ptr<const Place> place;  // null: it was removed
  int components = 0;
  Values values;
  std::size_t sample_count = 0;  // with which it was made; 0: by a function

  bool removed() const { return place == nullptr; }
  BoundaryValue value(const Point& where, double fraction_of_part) const;
  // The same with components that it does not act on at zero.
  BoundaryValue acting_value(const Point& where, double fraction_of_part) const;
  bool acts_on(int component) const { return (components >> component) & 1; }
};

}  // namespace bempd::scene

#pragma once

#include <array>
#include <cmath>

#include "geometry/point.hpp"

namespace bempd::bem {

// Basis functions on an element, besides the constant: an odd and an even function of the parameter -1 <= xi <= 1, both
// with the value 1 at xi = 1. They are xi and xi^2 on straight elements, and on circular arcs of half angle alpha
//   sin(alpha xi) / sin(alpha)  and  (1 - cos(alpha xi)) / (1 - cos(alpha)).
// The coordinates of the exact arc are combinations of these functions, as are linear displacements, rigid rotations
// and the tractions of constant stress. As alpha tends to zero, the two functions tend to xi and xi^2.
class ElementBasis {
 public:
  explicit ElementBasis(double half_angle = 0)
      : alpha_(half_angle),
        odd_scale_(half_angle == 0 ? 1 : 1 / std::sin(half_angle)),
        even_scale_(half_angle == 0 ? 1 : 1 / std::sin(0.5 * half_angle)) {}

  double half_angle() const { return alpha_; }
  bool powers() const { return alpha_ == 0; }

  double odd(double xi) const { return powers() ? xi : std::sin(alpha_ * xi) * odd_scale_; }
  double even(double xi) const {
    if (powers()) return xi * xi;
    const double root = std::sin(0.5 * alpha_ * xi) * even_scale_;
    return root * root;
  }
  double odd_slope(double xi) const { return powers() ? 1 : alpha_ * std::cos(alpha_ * xi) * odd_scale_; }
  double even_slope(double xi) const {
    return powers() ? 2 * xi : 0.5 * alpha_ * std::sin(alpha_ * xi) * even_scale_ * even_scale_;
  }
  struct Pair {
    double odd, even;
  };
  // Sine and cosine of alpha xi / 2, where alpha is the half angle of the arc and xi a parameter or a difference of two
  // parameters.
  struct HalfAngle {
    double sine = 0, cosine = 1;
    HalfAngle plus(const HalfAngle& other) const {
      return {sine * other.cosine + cosine * other.sine, cosine * other.cosine - sine * other.sine};
    }
  };
  HalfAngle half(double xi) const {
    return powers() ? HalfAngle{} : HalfAngle{std::sin(0.5 * alpha_ * xi), std::cos(0.5 * alpha_ * xi)};
  }
  // Values and slopes of the odd and the even function. On arcs all four are computed from one sine and one cosine.
  struct Values {
    Pair value, slope;
  };
  Values at(double xi) const { return at(xi, half(xi)); }
  Values at(double xi, const HalfAngle& of_xi) const {
    if (powers()) return {{xi, xi * xi}, {1, 2 * xi}};
    const auto [sine, cosine] = of_xi;
    const double root = sine * even_scale_;
    return {{2 * sine * cosine * odd_scale_, root * root},
            {alpha_ * (cosine - sine) * (cosine + sine) * odd_scale_, alpha_ * root * cosine * even_scale_}};
  }
  // Divided differences (f(xi) - f(from)) / (xi - from) of both functions, without cancellation.
  Pair quotients(double xi, double from) const {
    if (powers()) return {1, xi + from};
    const double mean = 0.5 * alpha_ * (xi + from), scale = alpha_ * sinc(0.5 * alpha_ * (xi - from));
    return {scale * odd_scale_ * std::cos(mean), 0.5 * scale * even_scale_ * even_scale_ * std::sin(mean)};
  }
  // Divided differences of both functions between `from` and from + way, where `way` is not 0; `of_from` and `of_way`
  // are half(from) and half(way).
  Pair quotients(double from, double way, const HalfAngle& of_from, const HalfAngle& of_way) const {
    if (powers()) return {1, 2 * from + way};
    const HalfAngle mean = of_from.plus(of_from).plus(of_way);
    const double scale = 2 * of_way.sine / way;
    return {scale * odd_scale_ * mean.cosine, 0.5 * scale * even_scale_ * even_scale_ * mean.sine};
  }

  // Remainder of the even function without its linear part in the odd function, even(xi) - even(from) - (odd(xi) -
  // odd(from)) even'(from) / odd'(from), without cancellation.
  double second_order(double xi, double from) const {
    const double d = xi - from;
    return powers() ? d * d : even(d) / std::cos(alpha_ * from);
  }

 private:
  static double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

  double alpha_, odd_scale_, even_scale_;
};

// End of an element that is a crack tip.
enum class TipEnd { none, start, end };

// Geometry x(xi) = c0 + c1 odd(xi) + c2 even(xi) of an element; straight when c2 vanishes. On an element at a crack
// tip, the vector from the tip is sigma^2 times the vector to the other end, where sigma runs from 0 at the tip to 1
// (quarter points; Barsoum, Int. J. Num. Meth. Eng. 10, 1976). The shape functions then span 1, sigma and sigma^3, so
// that openings have only the powers 1/2 and 3/2 of the distance.
struct ElementGeometry {
  Point c0, c1, c2;
  ElementBasis basis{};
  TipEnd tip = TipEnd::none;

  Point at(double xi) const { return c0 + basis.odd(xi) * c1 + basis.even(xi) * c2; }
  Point derivative(double xi) const { return basis.odd_slope(xi) * c1 + basis.even_slope(xi) * c2; }
  // Whether the element is straight and its parameter proportional to the length.
  bool straight() const { return c2.squaredNorm() <= 1e-24 * c1.squaredNorm(); }

  // Shape functions of the nodes (start, mid, end).
  std::array<double, 3> shape(double xi) const {
    if (tip != TipEnd::none) return tip_shape(xi);
    return nodal(basis.odd(xi), basis.even(xi), 1);
  }
  std::array<double, 3> shape_derivative(double xi) const {
    if (tip != TipEnd::none) return tip_shape_derivative(xi);
    return nodal(basis.odd_slope(xi), basis.even_slope(xi), 0);
  }
  // Values at a parameter xi: derivative of the position by xi, shape functions, and their derivatives by xi.
  struct Values {
    Point derivative;
    std::array<double, 3> shape, shape_derivative;
  };
  // Divided differences (f(xi) - f(from)) / (xi - from) of the position and of the shape functions, without
  // cancellation. The shape functions' differences are not valid for elements at a tip.
  struct Quotients {
    Point place;
    std::array<double, 3> shape;
  };
  Quotients quotients(double xi, double from) const { return quotients(basis.quotients(xi, from)); }
  // Values at from + way, and divided differences between `from` and from + way, where `way` is not 0. The arguments
  // `of_from` and `of_way` are basis.half(from) and basis.half(way), which several points may share.
  struct ValuesAndQuotients {
    Values values;
    Quotients quotients;
  };
  ValuesAndQuotients values_and_quotients(double from, double way, const ElementBasis::HalfAngle& of_from,
                                          const ElementBasis::HalfAngle& of_way) const {
    const double xi = from + way;
    return {values(xi, basis.at(xi, of_from.plus(of_way))), quotients(basis.quotients(from, way, of_from, of_way))};
  }
  Values values(double xi, const ElementBasis::Values& of_basis) const {
    const auto [value, slope] = of_basis;
    const Point along = slope.odd * c1 + slope.even * c2;
    if (tip != TipEnd::none) return {along, tip_shape(xi), tip_shape_derivative(xi)};
    return {along, nodal(value.odd, value.even, 1), nodal(slope.odd, slope.even, 0)};
  }

 private:
  Quotients quotients(const ElementBasis::Pair& q) const { return {q.odd * c1 + q.even * c2, nodal(q.odd, q.even, 0)}; }
  static std::array<double, 3> nodal(double odd, double even, double one) {
    return {0.5 * (even - odd), one - even, 0.5 * (even + odd)};
  }
  std::array<double, 3> from_tip(double at_tip, double mid, double far) const {
    if (tip == TipEnd::start) return {at_tip, mid, far};
    return {far, mid, at_tip};
  }
  std::array<double, 3> tip_shape(double xi) const {
    const double sigma = 0.5 * (tip == TipEnd::start ? 1 + xi : 1 - xi), cube = sigma * sigma * sigma;
    const double mid = 8.0 / 3 * (sigma - cube), far = (4 * cube - sigma) / 3;
    return from_tip(1 - mid - far, mid, far);
  }
  std::array<double, 3> tip_shape_derivative(double xi) const {
    const double sign = tip == TipEnd::start ? 0.5 : -0.5, sigma = 0.5 + sign * xi, square = 3 * sigma * sigma;
    const double mid = sign * 8.0 / 3 * (1 - square), far = sign * (4 * square - 1) / 3;
    return from_tip(-mid - far, mid, far);
  }
};

// Element through three nodes; `sweep` is the angle by which the tangent turns along an arc, 0 for a parabola or a
// straight element.
ElementGeometry element_through(const Point& start, const Point& mid, const Point& end, double sweep);

// Straight element from `start` to `end`, one of which (`tip`) is a crack tip.
ElementGeometry tip_element(const Point& start, const Point& end, TipEnd tip);

// Outward normal times the Jacobian |dx/dxi|; the body lies on the left of the element.
inline Point scaled_normal(const Point& derivative) { return {derivative.y(), -derivative.x()}; }

// Part of an element between two parameters within -1 <= xi <= 1, in either direction.
struct Interval {
  double from = -1, to = 1;
  double mid() const { return 0.5 * (from + to); }
  double at(double s) const { return from + s * (to - from); }
};

}  // namespace bempd::bem

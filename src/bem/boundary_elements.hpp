#pragma once

#include <array>
#include <vector>

#include "bem/quadrature.hpp"
#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Quadratic shape functions of the nodes (start, mid, end) on -1 <= xi <= 1.
inline std::array<double, 3> shape(double xi) { return {0.5 * xi * (xi - 1), 1 - xi * xi, 0.5 * xi * (xi + 1)}; }
inline std::array<double, 3> shape_derivative(double xi) { return {xi - 0.5, -2 * xi, xi + 0.5}; }
// (N(xi) - N(from)) / (xi - from), without cancellation.
inline std::array<double, 3> shape_difference_quotient(double xi, double from) {
  const double s = xi + from;
  return {0.5 * (s - 1), -s, 0.5 * (s + 1)};
}

// x(xi) = c0 + c1 xi + c2 xi^2; straight when c2 vanishes.
struct ElementGeometry {
  Point c0, c1, c2;

  Point at(double xi) const { return c0 + xi * (c1 + xi * c2); }
  Point derivative(double xi) const { return c1 + (2 * xi) * c2; }
  // (x(xi) - x(from)) / (xi - from), without cancellation.
  Point difference_quotient(double xi, double from) const { return c1 + (xi + from) * c2; }
  bool straight() const { return c2.squaredNorm() <= 1e-24 * c1.squaredNorm(); }
};

// Outward normal times the Jacobian |dx/dxi|: the body lies on the left.
inline Point scaled_normal(const Point& derivative) { return {derivative.y(), -derivative.x()}; }

// Part of an element within -1 <= xi <= 1, in either direction.
struct Interval {
  double from = -1, to = 1;
  double mid() const { return 0.5 * (from + to); }
  double at(double s) const { return from + s * (to - from); }
};

// Size of the ellipse around the interval in which the Jacobian is analytic; infinite for a straight element.
double jacobian_ellipse(const ElementGeometry& element, const Interval& interval);

// Quadrature points of one interval, as structure of arrays for the vector unit.
struct ElementPoints {
  using Values = std::array<double, max_regular_points>;
  int count = 0;
  Values x, y;                       // position
  Values normal_x, normal_y;         // outward normal * Jacobian * weight
  std::array<Values, 3> shape;       // N_k
  std::array<Values, 3> mass;        // N_k * Jacobian * weight
  std::array<Values, 3> derivative;  // dN_k/dxi * weight
};

void fill_points(const ElementGeometry& element, const Interval& interval, int point_count, ElementPoints& points);

// The boundary in lengths over the diagonal of its bounding box and relative to the box's centre. In these units the
// diameter is at most one, which keeps the single layer operator positive definite for every body (no degenerate
// scale).
struct ScaledBoundary {
  explicit ScaledBoundary(const BoundaryMesh& mesh);

  Point scaled(const Point& x) const { return (x - centre) / length; }

  Point centre;
  double length = 1;
  std::vector<ElementGeometry> elements;
};

}  // namespace bempd::bem

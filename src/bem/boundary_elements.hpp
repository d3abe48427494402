#pragma once

#include <array>
#include <vector>

#include "bem/element_geometry.hpp"
#include "bem/quadrature.hpp"
#include "geometry/boundary_mesh.hpp"

namespace bempd::bem {

// Quadrature points of one interval of an element, as structure of arrays for the vector unit.
struct ElementPoints {
  using Values = std::array<double, max_regular_points>;
  int count = 0;
  Values x, y;                  // positions; the first one is repeated behind the last, because whole vectors are read
  Values normal_x, normal_y;    // outward normal * Jacobian * weight
  std::array<Values, 3> shape;  // N_k
  std::array<Values, 3> mass;   // N_k * Jacobian * weight
  std::array<Values, 3> derivative;  // dN_k/dxi * weight
};

void fill_points(const ElementGeometry& element, const Interval& interval, int point_count, ElementPoints& points);

// Boundary of a body in scaled coordinates: relative to the centre of its bounding box, in units of the box's diagonal.
// The body's diameter is then at most 1, so that the single layer operator is positive definite for every shape (no
// degenerate scale).
struct ScaledBoundary {
  explicit ScaledBoundary(const BoundaryMesh& mesh);

  Point scaled(const Point& x) const { return (x - centre) / length; }

  Point centre;
  double length = 1;
  std::vector<ElementGeometry> elements;
};

}  // namespace bempd::bem

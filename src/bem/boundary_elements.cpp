#include "bem/boundary_elements.hpp"

#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

namespace bempd::bem {

double jacobian_ellipse(const ElementGeometry& element, const Interval& interval) {
  if (element.straight()) return std::numeric_limits<double>::infinity();
  // The Jacobian's square is dx/dxi . dx/dxi, which vanishes where c1 + 2 c2 xi does, read as complex numbers.
  const std::complex<double> c1(element.c1.x(), element.c1.y()), c2(element.c2.x(), element.c2.y());
  const std::complex<double> zero = -c1 / (2.0 * c2);
  const double half = 0.5 * (interval.to - interval.from);
  return ellipse_size((std::abs(zero - interval.from) + std::abs(zero - interval.to)) / half);
}

void fill_points(const ElementGeometry& element, const Interval& interval, int point_count, ElementPoints& points) {
  assert(point_count <= max_regular_points);
  const GaussRule& rule = gauss_rule(point_count);
  points.count = point_count;
  for (int p = 0; p < point_count; ++p) {
    const double xi = interval.at(rule.points[p]);
    const double weight = rule.weights[p] * (interval.to - interval.from);
    const Point x = element.at(xi), dx = element.derivative(xi), normal = scaled_normal(dx);
    const auto value = shape(xi), slope = shape_derivative(xi);
    points.x[p] = x.x();
    points.y[p] = x.y();
    points.normal_x[p] = normal.x() * weight;
    points.normal_y[p] = normal.y() * weight;
    for (int k = 0; k < 3; ++k) {
      points.shape[k][p] = value[k];
      points.mass[k][p] = value[k] * dx.norm() * weight;
      points.derivative[k][p] = slope[k] * weight;
    }
  }
}

ScaledBoundary::ScaledBoundary(const BoundaryMesh& mesh) {
  assert(!mesh.elements.empty());
  Point low = mesh.nodes.front(), high = low;
  for (const Point& x : mesh.nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  centre = 0.5 * (low + high);
  length = (high - low).norm();
  for (const BoundaryElement& e : mesh.elements) {
    const Point start = scaled(mesh.nodes[e.nodes[0]]);
    const Point mid = scaled(mesh.nodes[e.nodes[1]]);
    const Point end = scaled(mesh.nodes[e.nodes[2]]);
    elements.push_back({mid, 0.5 * (end - start), 0.5 * ((start - mid) + (end - mid))});
  }
}

}  // namespace bempd::bem

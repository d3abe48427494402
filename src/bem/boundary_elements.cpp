#include "bem/boundary_elements.hpp"

#include <cassert>

namespace bempd::bem {

ElementGeometry element_through(const Point& start, const Point& mid, const Point& end, double sweep) {
  return {mid, 0.5 * (end - start), 0.5 * ((start - mid) + (end - mid)), ElementBasis(0.5 * sweep)};
}

ElementGeometry tip_element(const Point& start, const Point& end, TipEnd tip) {
  assert(tip != TipEnd::none);
  const Point along = end - start, away = tip == TipEnd::start ? along : Point(-along);
  return {(tip == TipEnd::start ? start : end) + 0.25 * away, 0.5 * along, 0.25 * away, ElementBasis(), tip};
}

void fill_points(const ElementGeometry& element, const Interval& interval, int point_count, ElementPoints& points) {
  assert(point_count <= max_regular_points);
  const GaussRule& rule = gauss_rule(point_count);
  points.count = point_count;
  for (int p = 0; p < point_count; ++p) {
    const double xi = interval.at(rule.points[p]);
    const double weight = rule.weights[p] * (interval.to - interval.from);
    const Point x = element.at(xi), dx = element.derivative(xi), normal = scaled_normal(dx);
    const auto value = element.shape(xi), slope = element.shape_derivative(xi);
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
  for (int p = point_count; p < max_regular_points; ++p) {
    points.x[p] = points.x[0];
    points.y[p] = points.y[0];
    for (auto& shape : points.shape) shape[p] = 0;
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
    elements.push_back(element_through(start, mid, end, e.sweep));
  }
}

}  // namespace bempd::bem

#include "bem/crack_forces.hpp"

#include "bem/quadrature.hpp"

namespace bempd::bem {

namespace {

ElementGeometry geometry_of(const CrackElement& element, const Point& start, const Point& end) {
  return element.tip == TipEnd::none ? element_through(start, 0.5 * (start + end), end, 0)
                                     : tip_element(start, end, element.tip);
}

// Integrals of the three shape functions of an element times the traction on its left face.
std::array<Point, 3> node_forces(const ElementGeometry& geometry, int line, const FaceTraction& traction) {
  const GaussRule& rule = gauss_rule(8);
  std::array<Point, 3> forces{Point::Zero(), Point::Zero(), Point::Zero()};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double xi = 2 * rule.points[q] - 1;
    const Point dx = geometry.derivative(xi);
    const auto shape = geometry.shape(xi);
    const Point t = 2 * rule.weights[q] * dx.norm() * traction(line, geometry.at(xi), scaled_normal(dx.normalized()));
    for (int k = 0; k < 3; ++k) forces[k] += shape[k] * t;
  }
  return forces;
}

}  // namespace

Eigen::VectorXd crack_forces(const CrackMesh& cracks, const FaceTraction& traction, double thickness) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(cracks.nodes.size()));
  for (const CrackElement& e : cracks.elements) {
    const auto parts =
        node_forces(geometry_of(e, cracks.nodes[e.nodes[0]], cracks.nodes[e.nodes[2]]), e.line, traction);
    for (int k = 0; k < 3; ++k) forces.segment<2>(2 * e.nodes[k]) += thickness * parts[k];
  }
  return forces;
}

void add_forces_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks, const FaceTraction& traction,
                        double thickness, Eigen::Ref<Eigen::VectorXd> forces) {
  for (const CutElement& e : cracks.cuts) {
    const Point &start = mesh.nodes[e.left[0]], &end = mesh.nodes[e.left[2]];
    const auto parts = node_forces(element_through(start, 0.5 * (start + end), end, 0), e.line, traction);
    for (int k = 0; k < 3; ++k) {
      forces.segment<2>(2 * e.left[k]) += thickness * parts[k];
      forces.segment<2>(2 * e.right[k]) -= thickness * parts[k];
    }
  }
}

double work_of_growth(const CrackMesh& cracks, const CrackTip& tip, const FaceTraction& traction,
                      const Eigen::VectorXd& openings) {
  const CrackElement& e = cracks.elements[tip.element];
  const Point &start = cracks.nodes[e.nodes[0]], &end = cracks.nodes[e.nodes[2]];
  const double step = 1e-3 * (end - start).norm();
  const auto work = [&](double by) {
    const Point moved = tip.place + by * tip.direction;
    const auto parts = node_forces(tip.end == TipEnd::start ? geometry_of(e, moved, end) : geometry_of(e, start, moved),
                                   e.line, traction);
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += parts[k].dot(openings.segment<2>(2 * e.nodes[k]));
    return sum;
  };
  return (work(step) - work(-step)) / (2 * step);
}

}  // namespace bempd::bem

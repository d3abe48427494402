#include "bem/boundary_loads.hpp"

#include "bem/element_geometry.hpp"
#include "bem/quadrature.hpp"

namespace bempd::bem {

namespace {

// Calls add(shape functions, position, dx/dxi, weight) at the Gauss points of an element.
template <class Add>
void at_gauss_points(const BoundaryMesh& mesh, const BoundaryElement& element, const Add& add) {
  const GaussRule& rule = gauss_rule(8);
  const auto geometry = element_through(mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[1]],
                                        mesh.nodes[element.nodes[2]], element.sweep);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double xi = 2 * rule.points[q] - 1;
    add(geometry.shape(xi), geometry.at(xi), geometry.derivative(xi), 2 * rule.weights[q]);
  }
}

}  // namespace

void add_traction_forces(const BoundaryMesh& mesh, int panel, const std::function<Point(const Point&)>& traction,
                         double thickness, Eigen::Ref<Eigen::VectorXd> forces) {
  for (const BoundaryElement& element : mesh.elements) {
    if (element.panel != panel) continue;
    at_gauss_points(mesh, element,
                    [&](const std::array<double, 3>& shape, const Point& x, const Point& dx, double weight) {
                      const Point force = thickness * weight * dx.norm() * traction(x);
                      for (int k = 0; k < 3; ++k) forces.segment<2>(2 * element.nodes[k]) += shape[k] * force;
                    });
  }
}

void add_traction_forces(const BoundaryMesh& mesh, const BoundaryElement& element,
                         const Eigen::Matrix<double, 2, 3>& tractions, double thickness,
                         Eigen::Ref<Eigen::VectorXd> forces) {
  at_gauss_points(mesh, element, [&](const std::array<double, 3>& shape, const Point&, const Point& dx, double weight) {
    const Point traction = tractions * Eigen::Map<const Eigen::Vector3d>(shape.data());
    const Point force = thickness * weight * dx.norm() * traction;
    for (int k = 0; k < 3; ++k) forces.segment<2>(2 * element.nodes[k]) += shape[k] * force;
  });
}

void add_stress_forces(const BoundaryMesh& mesh, const std::function<Eigen::Vector3d(const Point&)>& stress,
                       double thickness, Eigen::Ref<Eigen::VectorXd> forces) {
  for (const BoundaryElement& element : mesh.elements) {
    at_gauss_points(
        mesh, element, [&](const std::array<double, 3>& shape, const Point& x, const Point& dx, double weight) {
          const Eigen::Vector3d s = stress(x);
          const Point n = scaled_normal(dx);
          const Point force = thickness * weight * Point(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y());
          for (int k = 0; k < 3; ++k) forces.segment<2>(2 * element.nodes[k]) += shape[k] * force;
        });
  }
}

void add_normal_integrals(const BoundaryMesh& mesh, Eigen::Ref<Eigen::VectorXd> integrals) {
  for (const BoundaryElement& element : mesh.elements) {
    at_gauss_points(mesh, element,
                    [&](const std::array<double, 3>& shape, const Point&, const Point& dx, double weight) {
                      for (int k = 0; k < 3; ++k)
                        integrals.segment<2>(2 * element.nodes[k]) += weight * shape[k] * scaled_normal(dx);
                    });
  }
}

// Integrates over the boundary only, by the divergence theorem: div (r f) = 2 f + r . grad f = (2 + degree) f, where r
// is the position relative to `centre`.
double integral_of_homogeneous(const BoundaryMesh& mesh, const Point& centre, int degree,
                               const std::function<double(const Point&)>& function) {
  const double share = 1.0 / (2 + degree);
  double sum = 0;
  for (const BoundaryElement& element : mesh.elements) {
    at_gauss_points(mesh, element, [&](const std::array<double, 3>&, const Point& x, const Point& dx, double weight) {
      sum += share * weight * function(x) * (x - centre).dot(scaled_normal(dx));
    });
  }
  return sum;
}

}  // namespace bempd::bem

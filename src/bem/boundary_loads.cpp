#include "bem/boundary_loads.hpp"

#include "bem/boundary_elements.hpp"

namespace bempd::bem {

void add_traction_forces(const BoundaryMesh& mesh, int panel, const std::function<Point(const Point&)>& traction,
                         double thickness, Eigen::Ref<Eigen::VectorXd> forces) {
  const GaussRule& rule = gauss_rule(8);
  for (const BoundaryElement& element : mesh.elements) {
    if (element.panel != panel) continue;
    const auto geometry = element_through(mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[1]],
                                          mesh.nodes[element.nodes[2]], element.sweep);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double xi = 2 * rule.points[q] - 1;
      const auto value = geometry.shape(xi);
      const double jacobian = geometry.derivative(xi).norm();
      const Point force = thickness * 2 * rule.weights[q] * jacobian * traction(geometry.at(xi));
      for (int k = 0; k < 3; ++k) forces.segment<2>(2 * element.nodes[k]) += value[k] * force;
    }
  }
}

}  // namespace bempd::bem

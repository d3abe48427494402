#include "bem/boundary_loads.hpp"

#include "bem/boundary_elements.hpp"

namespace bempd::bem {

void add_traction_forces(const BoundaryMesh& mesh, int panel, const std::function<Point(const Point&)>& traction,
                         double thickness, Eigen::Ref<Eigen::VectorXd> forces) {
  const GaussRule& rule = gauss_rule(8);
  for (const BoundaryElement& element : mesh.elements) {
    if (element.panel != panel) continue;
    const std::array<Point, 3> nodes{mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[1]],
                                     mesh.nodes[element.nodes[2]]};
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double xi = 2 * rule.points[q] - 1;
      const auto value = shape(xi), slope = shape_derivative(xi);
      const Point x = value[0] * nodes[0] + value[1] * nodes[1] + value[2] * nodes[2];
      const Point dx = slope[0] * nodes[0] + slope[1] * nodes[1] + slope[2] * nodes[2];
      const Point force = thickness * 2 * rule.weights[q] * dx.norm() * traction(x);
      for (int k = 0; k < 3; ++k) forces.segment<2>(2 * element.nodes[k]) += value[k] * force;
    }
  }
}

}  // namespace bempd::bem

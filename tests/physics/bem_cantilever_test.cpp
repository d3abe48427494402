#include "physics/bem_cantilever.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "bem/galerkin_operator.hpp"
#include "physics/bem_bodies.hpp"

namespace bem_cantilever_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

double displacement_error(const Cantilever& beam, double element_length) {
  const Body body{"cantilever", {rectangle(beam.length, beam.height, element_length, 1, {0, -beam.height / 2})}, {}};
  const BoundaryMesh mesh = mesh_boundary(body.loops);
  const auto stress = [&](const Point& x) { return beam.stress(x); };
  const bem::GalerkinOperator galerkin(mesh, beam.elasticity);
  const Eigen::VectorXd exact = nodal_values(mesh, [&](const Point& x) { return beam.displacement(x); });
  const Eigen::VectorXd forces = nodal_forces(mesh, body.panels(), stress, beam.elasticity.thickness);
  const Eigen::VectorXd u = solve_supported(galerkin.stiffness(), forces, fixed_on_panel(mesh, 3), exact);
  const double error = (u - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
  std::printf("%3zu elements: tip %.12e, exact %.12e, largest difference / largest displacement %.2e\n",
              mesh.elements.size(), u[2 * mesh.elements[mesh.elements.size() / 2].nodes[0] + 1],
              exact[2 * mesh.elements[mesh.elements.size() / 2].nodes[0] + 1], error);
  return error;
}

TEST(Cantilever, displacement_converges_with_at_least_order_three_and_a_half) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    const Cantilever beam{{100e9, 0.3, state, 0.05}};
    double last = displacement_error(beam, 0.1);
    for (const double element_length : {0.05, 0.025, 0.0125}) {
      const double error = displacement_error(beam, element_length);
      std::printf("             order %.2f\n", std::log2(last / error));
      EXPECT_GE(std::log2(last / error), 3.5);
      last = error;
    }
    EXPECT_LE(last, 1e-6);
  }
}

}  // namespace
}  // namespace bem_cantilever_test

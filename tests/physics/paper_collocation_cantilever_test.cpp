#include <gtest/gtest.h>

#include <cstdio>

#include "bem/galerkin_operator.hpp"
#include "paper/collocation_operator.hpp"
#include "physics/bem_cantilever.hpp"
#include "physics/paper_collocation_bodies.hpp"

namespace paper_collocation_cantilever_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

const Cantilever beam_in_stress{{100e9, 1.0 / 3, PlaneState::stress, 0.05}};
const Cantilever beam_in_strain{{100e9, 0.25, PlaneState::strain, 0.05}};

Body body_of(const Cantilever& beam, double element_length) {
  return {"cantilever", {rectangle(beam.length, beam.height, element_length, 1, {0, -beam.height / 2})}, {}};
}

double displacement_error(const Cantilever& beam, double element_length) {
  const Body body = body_of(beam, element_length);
  const BoundaryMesh mesh = mesh_boundary(body.loops);
  const paper::CollocationOperator collocation(mesh, beam.elasticity);
  const Eigen::VectorXd exact = nodal_values(mesh, [&](const Point& x) { return beam.displacement(x); });
  const Eigen::VectorXd forces = nodal_forces(
      mesh, body.panels(), [&](const Point& x) { return beam.stress(x); }, beam.elasticity.thickness);
  const Eigen::VectorXd u = solve_unsymmetric(collocation.stiffness(), forces, fixed_on_panel(mesh, 3), exact);
  const double error = (u - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
  const int tip = 2 * mesh.elements[mesh.elements.size() / 2].nodes[0] + 1;
  std::printf("%3zu elements: tip %.12e, exact %.12e, largest difference / largest displacement %.2e\n",
              mesh.elements.size(), u[tip], exact[tip], error);
  return error;
}

// The order is higher on coarse meshes and falls towards three, that of the equations at the nodes: the double layer of
// an odd interpolation error does not vanish there.
TEST(CollocationCantilever, displacement_converges_with_order_three_and_a_half_over_three_halvings) {
  for (const Cantilever& beam : {beam_in_stress, beam_in_strain}) {
    const double first = displacement_error(beam, 0.2);
    double last = first;
    for (const double element_length : {0.1, 0.05, 0.025}) {
      const double error = displacement_error(beam, element_length);
      std::printf("             order %.2f\n", std::log2(last / error));
      EXPECT_GE(std::log2(last / error), 3);
      last = error;
    }
    EXPECT_GE(std::log2(first / last) / 3, 3.5);
    const double finest = displacement_error(beam, 0.0125);
    std::printf("             order %.2f\n", std::log2(last / finest));
    EXPECT_GE(std::log2(last / finest), 3);
    EXPECT_LE(finest, 1e-6);
  }
}

// Strain energy of the exact boundary displacements.
TEST(CollocationCantilever, energy_of_a_smooth_field_agrees_with_the_exact_one_and_with_the_galerkin_operator) {
  const Cantilever& beam = beam_in_stress;
  double last = 0;
  for (const double element_length : {0.1, 0.05, 0.025}) {
    const Body body = body_of(beam, element_length);
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const Eigen::VectorXd u = nodal_values(mesh, [&](const Point& x) { return beam.displacement(x); });
    const Eigen::VectorXd forces = nodal_forces(
        mesh, body.panels(), [&](const Point& x) { return beam.stress(x); }, beam.elasticity.thickness);
    const paper::CollocationOperator collocation(mesh, beam.elasticity);
    const bem::GalerkinOperator galerkin(mesh, beam.elasticity);
    const double exact = 0.5 * u.dot(forces), by_collocation = 0.5 * u.dot(collocation.stiffness() * u);
    const double by_galerkin = 0.5 * u.dot(galerkin.stiffness() * u), error = std::abs(by_collocation / exact - 1);
    std::printf("%3zu elements: energy %.12e, exact %.12e, relative difference %.1e; Galerkin %.12e, difference %.1e\n",
                mesh.elements.size(), by_collocation, exact, error, by_galerkin,
                std::abs(by_collocation / by_galerkin - 1));
    if (last > 0) {
      EXPECT_GE(std::log2(last / error), 3.5);
    }
    EXPECT_LE(std::abs(by_collocation / by_galerkin - 1), 1e-4);
    last = error;
  }
  EXPECT_LE(last, 1e-6);
}

// Never symmetrise: the skew part carries the constant strains.
TEST(CollocationCantilever, stiffness_is_unsymmetric_at_every_mesh) {
  for (const double element_length : {0.1, 0.05, 0.025, 0.0125}) {
    const BoundaryMesh mesh = mesh_boundary(body_of(beam_in_stress, element_length).loops);
    const paper::CollocationOperator collocation(mesh, beam_in_stress.elasticity);
    const double value = asymmetry(collocation.stiffness());
    std::printf("%3zu elements: |K - K^T| / |K| = %.2e\n", mesh.elements.size(), value);
    EXPECT_GE(value, 0.05);
    EXPECT_LE(value, 0.2);
  }
}

}  // namespace
}  // namespace paper_collocation_cantilever_test

// Linear patch test: every constant strain state is an exact solution and must come back to rounding.

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "bem/galerkin_operator.hpp"
#include "physics/bem_bodies.hpp"

namespace bem_patch_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

struct PatchErrors {
  double tractions, forces, mixed, neumann;
};

double relative(const Eigen::VectorXd& value, const Eigen::VectorXd& reference) {
  return (value - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

PatchErrors patch_errors(const Body& body, const PlaneElasticity& elasticity, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::Matrix2d gradient;
  gradient << uniform(random), uniform(random), uniform(random), uniform(random);
  const BoundaryMesh mesh = mesh_boundary(body.loops);
  const std::vector<Panel> panels = body.panels();
  const double size = (panels[0].end - panels[0].start).norm();
  const Point shift = size * Point(uniform(random), uniform(random));
  const LinearField exact(elasticity, shift, gradient);
  const auto stress = [&](const Point&) { return exact.stress; };

  const bem::GalerkinOperator galerkin(mesh, elasticity);
  const Eigen::MatrixXd& k = galerkin.stiffness();
  const Eigen::VectorXd u = nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); });
  const Eigen::VectorXd f = nodal_forces(mesh, panels, stress, elasticity.thickness);
  const std::vector<bool> side = fixed_on_panel(mesh, static_cast<int>(body.loops[0].size()) - 1);
  return {relative(galerkin.tractions(u), nodal_tractions(mesh, panels, stress)), relative(k * u, f),
          relative(solve_supported(k, f, side, u), u),
          relative(solve_supported(k, f, fixed_rigid_motions(mesh), u), u)};
}

void print_and_check(const std::string& name, const PatchErrors& e) {
  std::printf("%-34s reference 0; tractions %.1e, nodal forces %.1e, displacements mixed %.1e, Neumann %.1e\n",
              name.c_str(), e.tractions, e.forces, e.mixed, e.neumann);
  EXPECT_LE(e.tractions, 2e-11) << name;
  EXPECT_LE(e.forces, 2e-12) << name;
}

// Slender bodies lose digits in displacements to the ratio of their axial and bending stiffness.
bool is_slender(const Body& body) { return body.name.find("strip") != std::string::npos; }

TEST(PatchTest, constant_strain_is_exact_in_dirichlet_neumann_and_mixed_problems) {
  unsigned seed = 1;
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const Body& body : bodies()) {
      const PatchErrors e = patch_errors(body, {70e9, 0.3, state, 0.01}, seed++);
      print_and_check(body.name + (state == PlaneState::stress ? ", stress" : ", strain"), e);
      EXPECT_LE(e.mixed, is_slender(body) ? 1e-8 : 2e-11);
      EXPECT_LE(e.neumann, is_slender(body) ? 1e-8 : 2e-11);
    }
}

TEST(PatchTest, holds_for_every_size_stiffness_and_poisson_ratio) {
  for (const double size : {1e-9, 1.0, 1e9})
    for (const double young : {1e-6, 1e15})
      for (const double nu : {-0.9, 0.0, 1.0 / 3, 0.49}) {
        Body body = bodies()[1];
        for (auto& loop : body.loops)
          for (Panel& panel : loop) panel.start *= size, panel.end *= size;
        const PatchErrors e = patch_errors(body, {young, nu, PlaneState::strain, 1}, 7);
        char name[80];
        std::snprintf(name, sizeof name, "L, size %.0e, E %.0e, nu %.2f", size, young, nu);
        print_and_check(name, e);
        EXPECT_LE(e.mixed, 2e-11);
        EXPECT_LE(e.neumann, 2e-11);
      }
}

TEST(PatchTest, quadrature_tolerance_controls_the_error) {
  const Body body = bodies()[2];
  const BoundaryMesh mesh = mesh_boundary(body.loops);
  const PlaneElasticity elasticity{1, 0.25, PlaneState::strain, 1};
  const Eigen::MatrixXd reference =
      bem::GalerkinOperator(mesh, elasticity, {.quadrature_tolerance = 1e-16}).stiffness();
  std::int64_t evaluations = 0;
  for (const double tolerance : {1e-6, 1e-10, 1e-14}) {
    const bem::GalerkinOperator galerkin(mesh, elasticity, {.quadrature_tolerance = tolerance});
    const double error = (galerkin.stiffness() - reference).norm() / reference.norm();
    std::printf("tolerance %.0e: stiffness off by %.1e, %lld kernel evaluations\n", tolerance, error,
                static_cast<long long>(galerkin.kernel_evaluations()));
    EXPECT_LE(error, 100 * tolerance);
    EXPECT_GT(galerkin.kernel_evaluations(), evaluations);
    evaluations = galerkin.kernel_evaluations();
  }
}

}  // namespace
}  // namespace bem_patch_test

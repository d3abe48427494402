#include <gtest/gtest.h>

#include "bem/boundary_loads.hpp"
#include "bem/galerkin_operator.hpp"
#include "dense.hpp"
#include "error.hpp"
#include "physics/bem_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::bem_test;

const PlaneElasticity steel{210e9, 0.3, PlaneState::strain, 0.02};

TEST(BoundaryLoads, forces_add_up_to_the_resultant_and_moment_of_the_traction) {
  const BoundaryMesh mesh = mesh_boundary({rectangle(2, 1, 0.3)});
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * mesh.nodes.size());
  // Quartic along the right side x = 2, 0 <= y <= 1.
  bem::add_traction_forces(
      mesh, 1, [](const Point& x) { return Point(5 * std::pow(x.y(), 4), 1 + x.y()); }, 0.5, forces);
  Point sum = Point::Zero();
  double moment = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    sum += forces.segment<2>(2 * n);
    moment += cross(mesh.nodes[n], forces.segment<2>(2 * n));
    const bool loaded = mesh.nodes[n].x() == 2;
    EXPECT_TRUE(loaded || forces.segment<2>(2 * n).norm() == 0);
  }
  EXPECT_NEAR(sum.x(), 0.5, 1e-14);
  EXPECT_NEAR(sum.y(), 0.75, 1e-14);
  EXPECT_NEAR(moment, 2 * 0.75 - 0.5 * 5.0 / 6.0, 1e-14);
}

TEST(GalerkinOperator, is_exactly_symmetric_with_three_rigid_motions_and_nothing_negative) {
  for (const Body& body : bodies()) {
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::GalerkinOperator galerkin(mesh, steel);
    const Eigen::MatrixXd& k = galerkin.stiffness();
    EXPECT_EQ((k - k.transpose()).cwiseAbs().maxCoeff(), 0) << body.name;
    const Eigen::VectorXd values = dense::eigenvalues(k);
    const double largest = values[values.size() - 1];
    for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(values[i]), 1e-14 * largest) << body.name;
    // The softest deformation of the thin strip, bending, is far stiffer than rounding.
    EXPECT_GE(values[3], 1e-8 * largest) << body.name;
  }
}

// Integrals with three digits do not tell the faces of a strip of width 1e-6 apart.
TEST(GalerkinOperator, one_that_cannot_be_factorized_is_an_error) {
  bem::AssemblyOptions coarse;
  coarse.quadrature_tolerance = 1e-3;
  try {
    const bem::GalerkinOperator galerkin(mesh_boundary({rectangle(1, 1e-6, 0.25)}), steel, coarse);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.failure(), Failure::unsolvable);
  }
}

TEST(GalerkinOperator, rigid_motions_need_no_force) {
  const Field motions[3] = {[](const Point&) { return Point(1, 0); }, [](const Point&) { return Point(0, 1); },
                            [](const Point& x) { return Point(-x.y(), x.x()); }};
  for (const Body& body : bodies()) {
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::GalerkinOperator galerkin(mesh, steel);
    for (const Field& motion : motions) {
      const Eigen::VectorXd u = nodal_values(mesh, motion);
      EXPECT_LE((galerkin.stiffness() * u).norm(), 1e-15 * galerkin.stiffness().norm() * u.norm()) << body.name;
    }
  }
}

TEST(GalerkinOperator, curved_elements_keep_rigid_motions_and_symmetry) {
  // An annulus of isoparametric arcs, made by bending the straight meshes of two regular polygons.
  std::vector<Point> outer, inner;
  for (int i = 0; i < 8; ++i)
    outer.emplace_back(2 * std::cos(i * std::numbers::pi / 4), 2 * std::sin(i * std::numbers::pi / 4));
  for (int i = 0; i < 8; ++i)
    inner.emplace_back(std::cos(i * std::numbers::pi / 4), -std::sin(i * std::numbers::pi / 4));
  BoundaryMesh mesh = mesh_boundary({polygon(outer, 10), polygon(inner, 10)});
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    mesh.nodes[n] *= (n < mesh.nodes.size() / 2 ? 2.0 : 1.0) / mesh.nodes[n].norm();
  const bem::GalerkinOperator galerkin(mesh, steel);
  const Eigen::MatrixXd& k = galerkin.stiffness();
  EXPECT_EQ((k - k.transpose()).cwiseAbs().maxCoeff(), 0);
  const Eigen::VectorXd turn = nodal_values(mesh, [](const Point& x) { return Point(-x.y(), x.x()); });
  EXPECT_LE((k * turn).norm(), 1e-13 * k.norm() * turn.norm());
  const Eigen::VectorXd values = dense::eigenvalues(k);
  EXPECT_GE(values[0], -1e-13 * values[values.size() - 1]);
  EXPECT_GE(values[3], 1e-5 * values[values.size() - 1]);
}

TEST(GalerkinOperator, is_bitwise_the_same_for_any_number_of_threads) {
  const Body body = bodies()[2];
  const BoundaryMesh mesh = mesh_boundary(body.loops);
  const bem::GalerkinOperator one(mesh, steel, {.threads = 1}), two(mesh, steel, {.threads = 2});
  EXPECT_TRUE(one.stiffness() == two.stiffness());
  EXPECT_EQ(one.kernel_evaluations(), two.kernel_evaluations());
}

TEST(GalerkinOperator, tractions_of_several_fields_are_those_of_each) {
  const BoundaryMesh mesh = mesh_boundary({rectangle(1, 0.5, 0.25)});
  const bem::GalerkinOperator galerkin(mesh, steel);
  Eigen::MatrixXd u(2 * mesh.nodes.size(), 2);
  u.col(0) = nodal_values(mesh, [](const Point& x) { return Point(x.x() * x.y(), x.y() * x.y()); });
  u.col(1) = nodal_values(mesh, [](const Point& x) { return Point(x.y(), 2 * x.x()); });
  const Eigen::MatrixXd both = galerkin.tractions(u);
  for (int c = 0; c < 2; ++c) {
    const Eigen::VectorXd single = galerkin.tractions(u.col(c));
    EXPECT_LE((both.col(c) - single).norm(), 1e-12 * single.norm());
  }
}

}  // namespace

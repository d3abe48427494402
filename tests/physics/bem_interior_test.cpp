#include <gtest/gtest.h>

#include <cstdio>

#include "bem/interior.hpp"
#include "physics/bem_bodies.hpp"
#include "physics/bem_cantilever.hpp"
#include "physics/circular_inclusion.hpp"

namespace bem_interior_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

Eigen::Vector3d components(const Eigen::Matrix2d& s) { return {s(0, 0), s(1, 1), s(0, 1)}; }

// Points at the given part of each element's length from the boundary, along the inner normal.
std::vector<Point> points_near_boundary(const BoundaryMesh& mesh, double part, const std::vector<double>& parameters) {
  std::vector<Point> points;
  for (const BoundaryElement& e : mesh.elements) {
    const Point &a = mesh.nodes[e.nodes[0]], &b = mesh.nodes[e.nodes[2]];
    const Point along = b - a, inward(-along.y(), along.x());
    for (const double xi : parameters) points.push_back(0.5 * (1 - xi) * a + 0.5 * (1 + xi) * b + part * inward);
  }
  return points;
}

TEST(InteriorEvaluator, linear_field_is_exact_everywhere_even_in_corners) {
  const PlaneElasticity elasticity{3e9, 0.35, PlaneState::strain, 1};
  Eigen::Matrix2d gradient;
  gradient << 1e-3, 4e-4, -7e-4, 6e-4;
  const LinearField exact(elasticity, {2e-4, -1e-4}, gradient);
  for (const Body& body : bodies()) {
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::InteriorEvaluator interior(
        mesh, elasticity, nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); }),
        nodal_tractions(mesh, body.panels(), [&](const Point&) { return exact.stress; }));
    for (const double part : {1e-2, 1e-6, 1e-9, 0.0}) {
      // Parameters short of the ends by `part` lie as close to the corners as to the sides.
      double displacement = 0, stress = 0;
      std::vector<Point> points = points_near_boundary(mesh, part, {-1 + 3 * part, -0.5, 0.1, 1 - 3 * part});
      points.push_back(body.inside);
      for (const Point& x : points) {
        const auto value = interior.at(x);
        displacement = std::max(displacement, (value.displacement - exact.displacement(x)).norm());
        stress = std::max(stress, (value.stress - components(exact.stress)).norm() / exact.stress.norm());
        EXPECT_EQ(interior.displacement_at(x), value.displacement);
      }
      std::printf("%-24s %.0e of an element from the boundary: u off by %.1e of 1e-3, stress by %.1e\n",
                  body.name.c_str(), part, displacement, stress);
      EXPECT_LE(displacement, 1e-3 * 1e-13);
      EXPECT_LE(stress, 1e-9);
    }
  }
}

TEST(InteriorEvaluator, stress_of_a_resolved_field_is_good_arbitrarily_close_to_the_boundary) {
  // Pure bending: sigma_xx = y, u = (x y, -(x^2 + nu y^2) / 2) / E; quadratic elements represent it exactly.
  const PlaneElasticity elasticity{2, 0.3, PlaneState::stress, 1};
  const auto displacement = [](const Point& x) -> Point {
    return 0.5 * Point(x.x() * x.y(), -0.5 * (x.x() * x.x() + 0.3 * x.y() * x.y()));
  };
  const auto stress = [](const Point& x) -> Eigen::Matrix2d { return Eigen::Vector2d(x.y(), 0).asDiagonal(); };
  for (const Body& body : bodies()) {
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::InteriorEvaluator interior(mesh, elasticity, nodal_values(mesh, displacement),
                                          nodal_tractions(mesh, body.panels(), stress));
    double largest = 0;
    for (const Point& x : mesh.nodes) largest = std::max(largest, std::abs(x.y()));
    for (const double part : {1e-2, 1e-4, 1e-6, 1e-8}) {
      double error = 0;
      for (const Point& x : points_near_boundary(mesh, part, {-0.8, -0.3, 0.0, 0.5}))
        error = std::max(error, (interior.at(x).stress - components(stress(x))).norm() / largest);
      std::printf("%-24s bending, %.0e of an element from the boundary: stress off by %.1e of the largest\n",
                  body.name.c_str(), part, error);
      EXPECT_LE(error, 1e-9);
    }
  }
}

TEST(InteriorEvaluator, error_near_the_boundary_is_the_interpolation_error_of_the_boundary_values) {
  // Cantilever: displacements are cubic along the elements, so their slopes are off by h^2; inside that averages out.
  const Cantilever beam{{100e9, 0.3, PlaneState::stress, 1}};
  const double largest = std::abs(beam.stress({0, 0.1})(0, 0));
  double last_inside = 0, last_near = 0;
  for (const double element_length : {0.05, 0.025, 0.0125}) {
    const Body body{"cantilever", {rectangle(1, 0.2, element_length, 1, {0, -0.1})}, {}};
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::InteriorEvaluator interior(
        mesh, beam.elasticity, nodal_values(mesh, [&](const Point& x) { return beam.displacement(x); }),
        nodal_tractions(mesh, body.panels(), [&](const Point& x) { return beam.stress(x); }));
    const auto error_at = [&](const std::vector<Point>& points) {
      double error = 0;
      for (const Point& x : points)
        error = std::max(error, (interior.at(x).stress - components(beam.stress(x))).norm() / largest);
      return error;
    };
    const double inside = error_at({{0.5, 0.03}, {0.31, -0.07}, {0.9, 0.01}});
    const double near = error_at(points_near_boundary(mesh, 1e-2, {-0.5, 0.0, 0.5}));
    const double nearer = error_at(points_near_boundary(mesh, 1e-8, {-0.5, 0.0, 0.5}));
    std::printf("element %.4f: stress off by %.1e inside, %.1e and %.1e at 1e-2 and 1e-8 of an element\n",
                element_length, inside, near, nearer);
    EXPECT_LE(nearer, 1.2 * near);
    if (last_near > 0) {
      EXPECT_GE(std::log2(last_near / near), 1.9);
      EXPECT_GE(std::log2(last_inside / inside), 3.5);
    }
    last_inside = inside;
    last_near = near;
  }
}

// Tractions and displacements of the plate with a hole (Kirsch) on a rectangle beside it, interpolated at the nodes.
TEST(InteriorEvaluator, stress_on_the_boundary_is_of_higher_order_than_the_elements_slopes) {
  const double young = 3, poisson = 0.2;
  const CircularInclusion plate(CircularInclusion::plane_strain(young, poisson));
  const auto displacement = [&](const Point& x) -> Point {
    const auto u = plate.displacement(x.x(), x.y());
    return {u[0], u[1]};
  };
  const auto stress = [&](const Point& x) {
    const auto s = plate.stress(x.x(), x.y());
    return Eigen::Matrix2d{{s[0], s[2]}, {s[2], s[1]}};
  };
  double last = 0;
  for (const double element_length : {0.25, 0.125, 0.0625}) {
    const Body body{"block", {rectangle(1, 0.75, element_length, 1, {0.9, 0.7})}, {}};
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::InteriorEvaluator interior(mesh, {young, poisson, PlaneState::strain, 1},
                                          nodal_values(mesh, displacement),
                                          nodal_tractions(mesh, body.panels(), stress));
    double error = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d found = interior.stress_on(static_cast<int>(e), k - 1);
        error = std::max(error, (found - components(stress(mesh.nodes[mesh.elements[e].nodes[k]]))).norm());
      }
    std::printf(
        "Kirsch beside the hole, elements of %.4f: stress at the nodes of all sides off by %.2e of 1, order %.2f\n",
        element_length, error, last > 0 ? std::log2(last / error) : 0.0);
    if (last > 0) {
      EXPECT_GE(std::log2(last / error), 2.9);
    }
    last = error;
  }
  EXPECT_LE(last, 1e-4);
}

}  // namespace
}  // namespace bem_interior_test

// Linear patch test on bodies with circular edges: elements lie on the exact arcs and represent every constant strain
// and its tractions, so the operator must return them to quadrature accuracy.

#include "physics/curved_patch.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "bem/galerkin_operator.hpp"
#include "bem/interior.hpp"

namespace curved_patch_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

TEST(CurvedPatch, constant_strain_and_rigid_motions_are_exact) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const Body& body : curved_bodies()) {
      const PlaneElasticity elasticity{2, 0.3, state, 1};
      const BoundaryMesh mesh = mesh_boundary(body.loops);
      const LinearField exact = some_field(elasticity);
      check_patch("Galerkin", body, mesh, exact, bem::GalerkinOperator(mesh, elasticity));
    }
}

// Points at the given part of each element's length from the boundary, along the inner normal.
std::vector<Point> points_near_boundary(const Body& body, double part, const std::vector<double>& places) {
  std::vector<Point> points;
  for (const Panel& panel : body.panels()) {
    const Arc arc = panel.arc();
    for (std::size_t i = 1; i < panel.stations.size(); ++i) {
      const double from = panel.stations[i - 1], to = panel.stations[i];
      for (const double place : places) {
        const double fraction = from + place * (to - from);
        const Point along = arc.tangent(fraction);
        points.push_back(arc.at(fraction) + part * (to - from) * arc.length() * Point(-along.y(), along.x()));
      }
    }
  }
  return points;
}

TEST(CurvedPatch, inside_values_are_exact_up_to_the_boundary) {
  const PlaneElasticity elasticity{2, 0.3, PlaneState::strain, 1};
  const LinearField exact = some_field(elasticity);
  const Eigen::Vector3d reference(exact.stress(0, 0), exact.stress(1, 1), exact.stress(0, 1));
  for (const Body& body : curved_bodies()) {
    const BoundaryMesh mesh = mesh_boundary(body.loops);
    const bem::InteriorEvaluator interior(
        mesh, elasticity, nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); }),
        curved_tractions(mesh, body.panels(), [&](const Point&) { return exact.stress; }));
    for (const double part : {1e-2, 1e-6, 1e-9, 0.0}) {
      // Points lie as close to the ends of the elements as to the elements.
      std::vector<Point> points = points_near_boundary(body, part, {3 * part, 0.3, 0.5, 1 - 3 * part});
      points.push_back(body.inside);
      double displacement = 0, stress = 0;
      for (const Point& x : points) {
        const auto value = interior.at(x);
        displacement = std::max(displacement, (value.displacement - exact.displacement(x)).norm());
        stress = std::max(stress, (value.stress - reference).norm() / reference.norm());
      }
      std::printf("%-26s %.0e of an element from the boundary: reference 0, u off by %.1e, stress by %.1e\n",
                  body.name.c_str(), part, displacement, stress);
      EXPECT_LE(displacement, 1e-13);
      EXPECT_LE(stress, 1e-9);
    }
  }
}

}  // namespace
}  // namespace curved_patch_test

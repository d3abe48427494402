// Linear patch test on bodies with circular edges: elements lie on the exact arcs and represent every constant strain
// and its tractions, so both operators must return them to quadrature accuracy.

#include <gtest/gtest.h>

#include <cstdio>

#include "bem/galerkin_operator.hpp"
#include "bem/interior.hpp"
#include "paper/collocation_operator.hpp"
#include "physics/curved_bodies.hpp"
#include "physics/paper_collocation_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::bem_test;

double relative(const Eigen::VectorXd& value, const Eigen::VectorXd& reference) {
  return (value - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

LinearField some_field(const PlaneElasticity& elasticity) {
  Eigen::Matrix2d gradient;
  gradient << 0.7, -0.3, 0.9, -0.4;
  return {elasticity, {0.2, -0.1}, gradient};
}

// Largest force of rigid motions with displacements of about one, over the forces of one node's motion.
double rigid_forces(const BoundaryMesh& mesh, const Eigen::MatrixXd& k) {
  Eigen::MatrixXd motions(k.cols(), 3);
  motions << nodal_values(mesh, [](const Point&) { return Point(1, 0); }),
      nodal_values(mesh, [](const Point&) { return Point(0, 1); }),
      nodal_values(mesh, [](const Point& x) { return Point(-x.y(), x.x()); });
  return (k * motions).cwiseAbs().maxCoeff() / k.cwiseAbs().maxCoeff();
}

void check_patch(const std::string& scheme, const Body& body, const BoundaryMesh& mesh, const LinearField& exact,
                 const bem::BoundaryOperator& boundary) {
  const std::vector<Panel> panels = body.panels();
  const StressField stress = [&](const Point&) { return exact.stress; };
  const Eigen::MatrixXd& k = boundary.stiffness();
  const Eigen::VectorXd u = nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); });
  const Eigen::VectorXd f = curved_forces(mesh, panels, stress, 1);
  const double tractions = relative(boundary.tractions(u), curved_tractions(mesh, panels, stress));
  const double forces = relative(k * u, f), rigid = rigid_forces(mesh, k);
  const double mixed = relative(solve_unsymmetric(k, f, fixed_on_panel(mesh, 0), u), u);
  std::printf("%-11s %-26s reference 0; tractions %.1e, nodal forces %.1e, displacements mixed %.1e, rigid %.1e\n",
              scheme.c_str(), body.name.c_str(), tractions, forces, mixed, rigid);
  EXPECT_LE(tractions, 1e-11);
  EXPECT_LE(forces, 1e-12);
  EXPECT_LE(mixed, 1e-12);
  EXPECT_LE(rigid, 1e-14);
}

TEST(CurvedPatch, constant_strain_and_rigid_motions_are_exact_in_both_schemes) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const Body& body : curved_bodies()) {
      const PlaneElasticity elasticity{2, 0.3, state, 1};
      const BoundaryMesh mesh = mesh_boundary(body.loops);
      const LinearField exact = some_field(elasticity);
      check_patch("Galerkin", body, mesh, exact, bem::GalerkinOperator(mesh, elasticity));
      check_patch("collocation", body, mesh, exact, paper::CollocationOperator(mesh, elasticity));
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
      // As close to the ends of the elements as to the elements.
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

#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "bem/boundary_operator.hpp"
#include "physics/curved_bodies.hpp"

// The linear patch test of a boundary operator on bodies with circular edges.
namespace bempd::bem_test {

inline double relative(const Eigen::VectorXd& value, const Eigen::VectorXd& reference) {
  return (value - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

inline LinearField some_field(const PlaneElasticity& elasticity) {
  Eigen::Matrix2d gradient;
  gradient << 0.7, -0.3, 0.9, -0.4;
  return {elasticity, {0.2, -0.1}, gradient};
}

// Largest force of rigid motions with displacements of about one, over the forces of one node's motion.
inline double rigid_forces(const BoundaryMesh& mesh, const Eigen::MatrixXd& k) {
  Eigen::MatrixXd motions(k.cols(), 3);
  motions << nodal_values(mesh, [](const Point&) { return Point(1, 0); }),
      nodal_values(mesh, [](const Point&) { return Point(0, 1); }),
      nodal_values(mesh, [](const Point& x) { return Point(-x.y(), x.x()); });
  return (k * motions).cwiseAbs().maxCoeff() / k.cwiseAbs().maxCoeff();
}

inline void check_patch(const std::string& scheme, const Body& body, const BoundaryMesh& mesh, const LinearField& exact,
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

}  // namespace bempd::bem_test

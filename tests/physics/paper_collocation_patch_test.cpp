// Linear patch test of the collocation operator: constant strains, given as boundary displacements, must yield their
// tractions to rounding, and supported bodies under their consistent loads must take them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "paper/collocation_operator.hpp"
#include "physics/paper_collocation_bodies.hpp"

namespace paper_collocation_patch_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

// Stress over Young's modulus.
struct StressState {
  double xx, yy, xy;
};
constexpr StressState general_state{1, -0.4, 0.7};

struct PatchErrors {
  double tractions, forces, mixed, rigid;
};

double relative(const Eigen::VectorXd& value, const Eigen::VectorXd& reference) {
  return (value - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

// Displacements with the given stress, a translation and a rotation.
LinearField field_of(const PlaneElasticity& elasticity, const StressState& state, double size) {
  const double xx = elasticity.young_modulus * state.xx, yy = elasticity.young_modulus * state.yy;
  const double c11 = elasticity.c11(), c12 = elasticity.c12(), determinant = (c11 - c12) * (c11 + c12);
  const double half_shear = elasticity.young_modulus * state.xy / (2 * elasticity.shear_modulus()), turn = 0.2;
  Eigen::Matrix2d gradient;
  gradient << (c11 * xx - c12 * yy) / determinant, half_shear - turn, half_shear + turn,
      (c11 * yy - c12 * xx) / determinant;
  return {elasticity, size * Point(0.3, -0.2), gradient};
}

// Largest force of translations and of a turn with displacements up to one, over the forces of one node's motion.
double rigid_forces(const BoundaryMesh& mesh, const Eigen::MatrixXd& k) {
  Eigen::MatrixXd motions(k.cols(), 3);
  motions << nodal_values(mesh, [](const Point&) { return Point(1, 0); }),
      nodal_values(mesh, [](const Point&) { return Point(0, 1); }),
      nodal_values(mesh, [](const Point& x) { return Point(-x.y(), x.x()); });
  motions.col(2) /= motions.col(2).cwiseAbs().maxCoeff();
  return (k * motions).cwiseAbs().maxCoeff() / k.cwiseAbs().maxCoeff();
}

PatchErrors patch_errors(const std::string& name, const Body& body, const PlaneElasticity& elasticity,
                         const StressState& state, bool one_traction_at_corners = false) {
  BoundaryMesh mesh = mesh_boundary(body.loops);
  if (one_traction_at_corners) mesh = paper::with_one_traction_at_corners(mesh);
  const std::vector<Panel> panels = body.panels();
  const LinearField exact = field_of(elasticity, state, (panels[0].end - panels[0].start).norm());
  const auto stress = [&](const Point&) { return exact.stress; };

  const paper::CollocationOperator collocation(mesh, elasticity);
  const Eigen::MatrixXd& k = collocation.stiffness();
  const Eigen::VectorXd u = nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); });
  const Eigen::VectorXd f = nodal_forces(mesh, panels, stress, elasticity.thickness);
  const std::vector<bool> side = fixed_on_panel(mesh, static_cast<int>(body.loops[0].size()) - 1);
  const PatchErrors e{relative(collocation.tractions(u), nodal_tractions(mesh, panels, stress)), relative(k * u, f),
                      relative(solve_unsymmetric(k, f, side, u), u), rigid_forces(mesh, k)};
  std::printf(
      "%-40s %4zu elements: reference 0; tractions %.1e, nodal forces %.1e, displacements mixed %.1e, rigid motions "
      "%.1e\n",
      name.c_str(), mesh.elements.size(), e.tractions, e.forces, e.mixed, e.rigid);
  return e;
}

constexpr PlaneElasticity stress_third{1, 1.0 / 3, PlaneState::stress, 0.01};
constexpr PlaneElasticity strain_quarter{1, 0.25, PlaneState::strain, 0.01};

TEST(CollocationPatch, constant_strain_is_exact_for_every_size_and_stiffness) {
  for (const PlaneElasticity& material : {stress_third, strain_quarter})
    for (const StressState& state : {general_state, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      for (const double size : {1e-9, 1.0, 1e9})
        for (const double young : {1e-6, 1e15}) {
          PlaneElasticity elasticity = material;
          elasticity.young_modulus = young;
          const Body strip{"strip", {rectangle(size, 0.2 * size, size / (young > 1 ? 6 : 20))}, {}};
          char name[80];
          std::snprintf(name, sizeof name, "nu %.2f, size %.0e, E %.0e", material.poisson_ratio, size, young);
          const PatchErrors e = patch_errors(name, strip, elasticity, state);
          EXPECT_LE(e.tractions, 1e-12);
          EXPECT_LE(e.forces, 1e-12);
          EXPECT_LE(e.mixed, 1e-12);
          EXPECT_LE(e.rigid, 1e-14);
        }
}

// The single layer is nearly blind to a uniform pressure (t = n): 1 / (1 - 2 nu) of the digits are lost.
TEST(CollocationPatch, nearly_incompressible_bodies_lose_only_the_digits_of_the_pressure) {
  for (const double nu : {0.49, 0.499, 0.499999})
    for (const StressState& state : {general_state, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      const Body strip{"strip", {rectangle(1, 0.2, 1.0 / 6)}, {}};
      char name[80];
      std::snprintf(name, sizeof name, "plane strain, nu %.6f", nu);
      const PatchErrors e = patch_errors(name, strip, {1e9, nu, PlaneState::strain, 0.01}, state);
      EXPECT_LE(e.tractions, std::max(1e-12, 2e-15 / (1 - 2 * nu)));
      EXPECT_LE(e.forces, std::max(1e-12, 2e-15 / (1 - 2 * nu)));
      EXPECT_LE(e.mixed, std::max(1e-12, 1e-14 / (1 - 2 * nu)));
      EXPECT_LE(e.rigid, 1e-14);
    }
}

// Tractions are difference quotients of displacements that are rounded: small elements in a large body lose digits.
double shortest_element(const Body& body) {
  double shortest = 1e300;
  for (const Panel& panel : body.panels())
    for (std::size_t i = 1; i < panel.stations.size(); ++i)
      shortest = std::min(shortest, (panel.stations[i] - panel.stations[i - 1]) * (panel.end - panel.start).norm());
  return shortest;
}

TEST(CollocationPatch, constant_strain_is_exact_in_holed_notched_graded_and_pointed_bodies) {
  for (const PlaneElasticity& elasticity : {stress_third, strain_quarter})
    for (const Body& body : bodies()) {
      const PatchErrors e = patch_errors(body.name, body, elasticity, general_state);
      EXPECT_LE(e.tractions, std::max(1e-12, 2e-14 / shortest_element(body)));
      EXPECT_LE(e.forces, 1e-12);
      EXPECT_LE(e.rigid, 1e-14);
      if (body.name.find("strip") == std::string::npos) {
        EXPECT_LE(e.mixed, 1e-12);
      }
    }
}

// Bending is softer than the stretching of an element by powers of the slenderness, and displacements lose that much.
TEST(CollocationPatch, slender_strips_lose_digits_only_in_displacements) {
  for (const double slenderness : {50.0, 1000.0})
    for (const double target : {0.1, 0.05, 0.01}) {
      const Body strip{
          "strip 1:" + std::to_string(std::lround(slenderness)), {rectangle(1, 1 / slenderness, target)}, {}};
      const PatchErrors e = patch_errors(strip.name, strip, stress_third, general_state);
      EXPECT_LE(e.tractions, 2e-11);
      EXPECT_LE(e.forces, 5e-12);
      EXPECT_LE(e.rigid, 1e-14);
      EXPECT_LE(e.mixed, 2e-16 * std::pow(slenderness, 4));
    }
}

// Tractions that jump at a corner have no place in one common value: the reference here is not reached, only rigid
// motions are. The numbers show what that choice costs.
TEST(CollocationPatch, one_traction_at_corners_keeps_rigid_motions_but_not_constant_strain) {
  for (const Body& body : bodies()) {
    const PatchErrors e = patch_errors("one traction, " + body.name, body, stress_third, general_state, true);
    EXPECT_LE(e.rigid, 1e-14);
    EXPECT_GE(e.forces, 1e-3);
  }
}

}  // namespace
}  // namespace paper_collocation_patch_test

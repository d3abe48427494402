// Linear patch test on bodies that are thin, or slit, or end in needles: exact up to the digits that rounded places
// leave of the thickness, with work that grows with the logarithm of length over thickness.

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "bem/galerkin_operator.hpp"
#include "physics/curved_bodies.hpp"

namespace bem_thin_patch_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

struct ThinBody {
  Body body;
  double lost;  // rounding errors over the gap that nodal forces may have: thin bodies stretch far more than they bend
};

std::vector<ThinBody> thin_bodies(double gap) {
  std::vector<ThinBody> all;
  all.push_back({{"strip", {rectangle(10, 10 * gap, 1)}, {}}, 50});
  const std::vector<Point> slot{{3, 5}, {3, 5 + 10 * gap}, {7, 5 + 10 * gap}, {7, 5}};
  all.push_back({{"slot", {rectangle(10, 10, 2.5), polygon(slot, 0.5)}, {}}, 0});
  all.push_back({{"needle", {polygon({{0, 0}, {10, 0}, {10, 10 * gap}}, 1)}, {}}, 500});
  all.push_back({{"thin ring", {circle({0, 0}, 5, 1), circle({0, 0}, 5 - 10 * gap, 1, -1)}, {}}, 50});
  all.push_back({{"hole close to the rim", {circle({0, 0}, 5, 1), circle({3 - 10 * gap, 0}, 2, 1, -1)}, {}}, 0});
  return all;
}

double relative(const Eigen::VectorXd& value, const Eigen::VectorXd& reference) {
  return (value - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
}

TEST(ThinPatch, work_grows_with_a_logarithm_and_constant_strain_stays_exact) {
  const PlaneElasticity elasticity{2, 0.3, PlaneState::stress, 1};
  Eigen::Matrix2d gradient;
  gradient << 0.7, -0.3, 0.9, -0.4;
  const LinearField exact(elasticity, {0.2, -0.1}, gradient);
  const StressField stress = [&](const Point&) { return exact.stress; };
  std::vector<std::int64_t> at_first;
  for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    std::size_t kind = 0;
    for (const auto& [body, lost] : thin_bodies(gap)) {
      const BoundaryMesh mesh = mesh_boundary(body.loops);
      const bem::GalerkinOperator galerkin(mesh, elasticity);
      const Eigen::VectorXd u = nodal_values(mesh, [&](const Point& x) { return exact.displacement(x); });
      const double forces = relative(galerkin.stiffness() * u, curved_forces(mesh, body.panels(), stress, 1));
      const double tractions = relative(galerkin.tractions(u), curved_tractions(mesh, body.panels(), stress));
      std::printf("gap %.0e, %-22s %3zu elements, %9lld evaluations; reference 0; tractions %.1e, forces %.1e\n", gap,
                  body.name.c_str(), mesh.elements.size(), static_cast<long long>(galerkin.kernel_evaluations()),
                  tractions, forces);
      constexpr double epsilon = std::numeric_limits<double>::epsilon();
      EXPECT_LE(forces, 5e-12 + lost * epsilon / gap) << body.name;
      EXPECT_LE(tractions, 2e-11 + 1e3 * epsilon / gap) << body.name;
      if (at_first.size() <= kind) at_first.push_back(galerkin.kernel_evaluations());
      // The square of the logarithm grows by 16 over these gaps, the length over the gap by a million.
      EXPECT_LE(galerkin.kernel_evaluations(), 16 * at_first[kind]) << body.name;
      ++kind;
    }
  }
}

}  // namespace
}  // namespace bem_thin_patch_test

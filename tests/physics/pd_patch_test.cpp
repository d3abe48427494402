#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "thorough.hpp"
#include "unit/pd_bodies.hpp"

namespace pd_patch_test {
namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

double patch_error(const Body& body, int m, const PlaneElasticity& elasticity) {
  Eigen::Matrix2d gradient;
  gradient << 0.71, -0.32, 0.55, -0.43;
  const CellLattice lattice(body.loops);
  const Network network = build_network(lattice, m, elasticity);
  const double c11 = elasticity.c11(), c12 = elasticity.c12(), g = elasticity.shear_modulus();
  Eigen::Matrix2d stress;
  stress << c11 * gradient(0, 0) + c12 * gradient(1, 1), g * (gradient(0, 1) + gradient(1, 0)),
      g * (gradient(0, 1) + gradient(1, 0)), c12 * gradient(0, 0) + c11 * gradient(1, 1);
  const Eigen::VectorXd forces =
      elasticity.thickness * boundary_forces(lattice, body.loops, [&](const Point&) { return stress; });
  Eigen::VectorXd exact(forces.size());
  for (int i = 0; i < lattice.point_count(); ++i) exact.segment<2>(2 * i) = gradient * lattice.point(i).cast<double>();
  const Eigen::VectorXd u = solve_pinned(lattice, network, forces, exact, cell_squares(elasticity));
  return (u - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
}

// A body under the tractions of a constant stress takes on the linear displacement field everywhere.
TEST(PatchTest, constant_strain_is_exact_up_to_faces_and_corners) {
  for (const Body& body : bodies()) {
    for (const int m : {2, 3, 4, 5}) {
      const CellLattice lattice(body.loops);
      const PlaneState state = m == 3 ? PlaneState::strain : PlaneState::stress;
      const PlaneElasticity elasticity = bond_based(2.1e11, state, 0.01);
      const double error = patch_error(body, m, elasticity);
      std::printf("%-18s m = %d  largest displacement error / displacement %.1e\n", body.name.c_str(), m, error);
      EXPECT_LT(error, 1e-11);
    }
  }
}

// Bonds and squares of cells together, at every face without any correction.
TEST(PatchTest, constant_strain_is_exact_for_any_poissons_ratio) {
  const std::vector<double> ratios{-0.2, 0.0, 0.2, 0.3, 0.4, 0.45, 0.49};
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    for (const double ratio : ratios) {
      // Every horizon with the ratios at the ends, if the test is thorough, and one of them with each between.
      const bool is_between = !bempd_tests::is_thorough() || (ratio != ratios.front() && ratio != ratios.back());
      for (const int m : {2, 3, 4}) {
        if (is_between && m != 2 + std::lround(100 * ratio) % 3) continue;
        double largest = 0;
        for (const Body& body : bodies())
          largest = std::max(largest, patch_error(body, m, {2.1e11, ratio, state, 0.01}));
        std::printf("%s, nu %5.2f, m = %d: largest displacement error / displacement, %zu bodies, %.1e\n",
                    state == PlaneState::stress ? "plane stress" : "plane strain", ratio, m, bodies().size(), largest);
        EXPECT_LT(largest, 1e-11);
      }
    }
  }
}

TEST(PatchTest, rigid_motions_cause_no_forces) {
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    const Network network = build_network(lattice, 4, bond_based(1, PlaneState::stress, 1));
    const auto matrix = stiffness_matrix(lattice, network);
    Eigen::VectorXd u(2 * lattice.point_count());
    for (int i = 0; i < lattice.point_count(); ++i) {
      u.segment<2>(2 * i) = Eigen::Vector2d(3 - 0.2 * lattice.point(i).y(), 5 + 0.2 * lattice.point(i).x());
    }
    EXPECT_LT((matrix * u).lpNorm<Eigen::Infinity>(), 1e-13) << body.name;
  }
}

}  // namespace
}  // namespace pd_patch_test

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "dense.hpp"
#include "unit/pd_bodies.hpp"

namespace pd_kirsch_test {
namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

// Infinite plate with a hole of radius 1 under unit tension along x (Kirsch 1898; Timoshenko and Goodier, Theory of
// Elasticity, art. 35).
Eigen::Matrix2d kirsch_stress(const Point& x) {
  const double r2 = x.squaredNorm(), r4 = r2 * r2, t = std::atan2(x.y(), x.x());
  const double c2 = std::cos(2 * t), c4 = std::cos(4 * t), s2 = std::sin(2 * t), s4 = std::sin(4 * t);
  const double xx = 1 - (1.5 * c2 + c4) / r2 + 1.5 * c4 / r4, yy = -(0.5 * c2 - c4) / r2 - 1.5 * c4 / r4;
  const double xy = -(0.5 * s2 + s4) / r2 + 1.5 * s4 / r4;
  return (Eigen::Matrix2d() << xx, xy, xy, yy).finished();
}

Point kirsch_displacement(const Point& x, const PlaneElasticity& elasticity) {
  const double kappa = 3 - 4 * elasticity.effective_poisson_ratio(), r = x.norm(), t = std::atan2(x.y(), x.x());
  const double r3 = r * r * r;
  return Point(r * (kappa + 1) * std::cos(t) + 2 / r * ((1 + kappa) * std::cos(t) + std::cos(3 * t)) -
                   2 / r3 * std::cos(3 * t),
               r * (kappa - 3) * std::sin(t) + 2 / r * ((1 - kappa) * std::sin(t) + std::sin(3 * t)) -
                   2 / r3 * std::sin(3 * t)) /
         (8 * elasticity.shear_modulus());
}

// Square of side 1 beside the hole, loaded by the exact tractions. Rigid motions are fitted away.
double relative_error(int cells, int m, const PlaneElasticity& elasticity) {
  const std::vector<Loop> loops = {rectangle(0, 0, cells, cells)};
  const CellLattice lattice(loops);
  const double spacing = 1.0 / cells;
  const auto place = [&](const Point& x) { return Point(Point(0.8, 0.8) + spacing * x); };
  const Eigen::VectorXd forces =
      spacing * boundary_forces(lattice, loops, [&](const Point& x) { return kirsch_stress(place(x)); });
  const int n = lattice.point_count();
  Eigen::VectorXd exact(2 * n);
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const Point x = lattice.point(i).cast<double>();
    exact.segment<2>(2 * i) = kirsch_displacement(place(x), elasticity);
    rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1;
    rigid(2 * i, 2) = -x.y(), rigid(2 * i + 1, 2) = x.x();
  }
  const Network network = build_network(lattice, m, elasticity);
  const Eigen::VectorXd u = solve_pinned(lattice, network, forces, exact, cell_squares(elasticity));
  const auto without_rigid = [&](const Eigen::VectorXd& v) {
    return Eigen::VectorXd(v - rigid * dense::least_squares(rigid, v));
  };
  return without_rigid(u - exact).norm() / without_rigid(exact).norm();
}

double order_of_convergence(int m, const PlaneElasticity& elasticity) {
  const double e10 = relative_error(10, m, elasticity), e20 = relative_error(20, m, elasticity);
  const double e40 = relative_error(40, m, elasticity), order = std::log2(e20 / e40);
  std::printf("nu %5.2f m = %d  error at 10, 20, 40 cells: %.2e %.2e %.2e, order %.2f\n", elasticity.poisson_ratio, m,
              e10, e20, e40, order);
  EXPECT_LT(e20, 5e-3);
  return order;
}

TEST(KirschField, converges_with_second_order) {
  for (const int m : {2, 3, 4, 5}) EXPECT_GE(order_of_convergence(m, bond_based(1, PlaneState::stress, 1)), 1.9);
}

TEST(KirschField, converges_with_second_order_for_any_poissons_ratio) {
  for (const double ratio : {-0.2, 0.2, 0.45})
    EXPECT_GE(order_of_convergence(4, {1, ratio, PlaneState::stress, 1}), 1.9);
  for (const double ratio : {0.0, 0.49}) EXPECT_GE(order_of_convergence(3, {1, ratio, PlaneState::strain, 1}), 1.9);
}

}  // namespace
}  // namespace pd_kirsch_test

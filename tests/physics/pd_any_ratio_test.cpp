// Lattices of any Poisson's ratio, bonds and squares of cells: no motion without resistance but the rigid ones, and no
// locking towards incompressibility.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "dense.hpp"
#include "unit/pd_bodies.hpp"

namespace pd_any_ratio_test {
namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

// The softest motion that is not rigid bends the square; a spurious one would resist by rounding only.
TEST(AnyRatio, has_no_spurious_motion) {
  const CellLattice lattice({rectangle(0, 0, 9, 9)});
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    for (const double ratio : {-0.2, 0.0, 0.2, 0.4, 0.49}) {
      for (const int m : {2, 3, 4}) {
        const PlaneElasticity elasticity{1, ratio, state, 1};
        const Network network = build_network(lattice, m, elasticity);
        const Eigen::MatrixXd matrix = stiffness_matrix(lattice, network, cell_squares(elasticity));
        const Eigen::VectorXd values = dense::eigenvalues(matrix) / elasticity.shear_modulus();
        std::printf("%s nu %5.2f m = %d: eigenvalues over the shear modulus %8.1e %8.1e %8.1e | %.3f .. %.1f\n",
                    state == PlaneState::stress ? "stress" : "strain", ratio, m, values[0], values[1], values[2],
                    values[3], values[values.size() - 1]);
        EXPECT_LT(values.head<3>().cwiseAbs().maxCoeff(), 1e-12 * values[values.size() - 1]);
        EXPECT_GT(values[3], 0.02);
      }
    }
  }
}

// Cantilever under a parabolic end shear (Timoshenko and Goodier, Theory of Elasticity, art. 21), in plane strain.
double cantilever_error(int cells_high, int m, const PlaneElasticity& elasticity) {
  const int n = cells_high;
  const std::vector<Loop> loops = {rectangle(0, 0, 4 * n, n)};
  const CellLattice lattice(loops);
  const double nu = elasticity.effective_poisson_ratio() / (1 - elasticity.effective_poisson_ratio());
  const double young = 2 * elasticity.shear_modulus() * (1 + nu), length = 4 * n, c = 0.5 * n;
  const double inertia = 2 * c * c * c / 3, f = 1 / (6 * young * inertia);
  const auto stress = [&](const Point& p) {
    const double y = p.y() - c, shear = (c * c - y * y) / (2 * inertia);
    return (Eigen::Matrix2d() << -(length - p.x()) * y / inertia, shear, shear, 0).finished();
  };
  Eigen::VectorXd exact(2 * lattice.point_count());
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(exact.size(), 3);
  for (int i = 0; i < lattice.point_count(); ++i) {
    const double x = lattice.point(i).x(), y = lattice.point(i).y() - c;
    exact.segment<2>(2 * i) << -f * y * ((6 * length - 3 * x) * x + (2 + nu) * (y * y - c * c)),
        f * (3 * nu * y * y * (length - x) + (4 + 5 * nu) * c * c * x + (3 * length - x) * x * x);
    rigid.block<2, 3>(2 * i, 0) << 1, 0, -y, 0, 1, x;
  }
  const Eigen::VectorXd forces = boundary_forces(lattice, loops, stress);
  const Network network = build_network(lattice, m, elasticity);
  const Eigen::VectorXd u = solve_pinned(lattice, network, forces, exact, cell_squares(elasticity));
  const Eigen::VectorXd error = u - exact - rigid * dense::least_squares(rigid, u - exact);
  return error.lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
}

TEST(AnyRatio, does_not_lock) {
  for (const double ratio : {0.25, 0.49, 0.4999, 0.499999}) {
    const double error = cantilever_error(20, 4, {1, ratio, PlaneState::strain, 1});
    std::printf("cantilever of 80 x 20 cells, plane strain, nu %.6f: largest error / largest displacement %.2e\n",
                ratio, error);
    EXPECT_LT(error, 4e-3);
  }
}

}  // namespace
}  // namespace pd_any_ratio_test

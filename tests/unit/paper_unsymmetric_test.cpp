#include <gtest/gtest.h>

#include "paper/unsymmetric_solution.hpp"
#include "unit/coupling_chain.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

// An operator that is not symmetric; the factor is left stale by the break.
TEST(EquilibriumSystem, unsymmetric_operators_are_solved_also_after_breaks) {
  Chain chain;
  chain.op.method = &paper::unsymmetric_solution();
  const Eigen::MatrixXd skew = Eigen::MatrixXd::NullaryExpr(
      6, 6, [](Eigen::Index i, Eigen::Index j) { return 0.3 * std::sin(static_cast<double>(5 * i + 11 * j)); });
  chain.op.stiffness = std::make_shared<const Eigen::MatrixXd>(*chain.op.stiffness + skew);
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed);
  EXPECT_FALSE(system.is_symmetric());
  Affine force = Affine::Zero(10, 2), given = Affine::Zero(10, 2);
  for (int dof = 0; dof < 10; ++dof) force.row(dof) << std::cos(dof), std::sin(2 * dof);
  given.row(0) << 0.1, 0.2;
  given.row(9) << -0.3, 0.05;
  system.set_load(force, given);
  const auto expected = [&] {
    const Eigen::MatrixXd k = chain.full(system.stages().intact());
    const std::vector<int> free{1, 2, 3, 4, 5, 6, 7, 8};
    Affine u = given;
    const Affine rhs = force - k * given;
    const Affine solved = dense::solve(k(free, free), rhs(free, Eigen::all));
    for (std::size_t i = 0; i < free.size(); ++i) u.row(free[i]) = solved.row(static_cast<Eigen::Index>(i));
    return u;
  };
  EXPECT_LE((system.solve() - expected()).cwiseAbs().maxCoeff(), 1e-10);
  const int broken[] = {0, 3};
  system.commit(system.stages().breaking(broken), {});
  EXPECT_LE((system.solve() - expected()).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(system.counters().sparse_factorizations, 1) << "the stale factor still preconditions";
}

}  // namespace
